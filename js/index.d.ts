/** Numbers: doubles, BigInts, or texts such as "1/3", all read exactly. */
export type Coordinate = number | bigint | string;
/** Rows of coordinates, or flat ones with the option `dimension`. */
export type Points = ReadonlyArray<ArrayLike<Coordinate>> | ArrayLike<Coordinate>;
/** Rows of indices of points, from 0, or flat ones, or a triangulation that was built. */
export type Simplices = ReadonlyArray<ArrayLike<number | bigint>> | ArrayLike<number | bigint> | Triangulation;

/** An object with points and simplices, by these names or by those of Delaunator and d3-delaunay. */
export interface MeshLike {
  points?: Points; coords?: Points; vertices?: Points; positions?: Points;
  simplices?: Simplices; triangles?: Simplices; tetrahedra?: Simplices; cells?: Simplices;
  dimension?: number; weights?: ArrayLike<Coordinate>;
}

/** A piecewise linear complex: what a mesh must fill. */
export interface Domain {
  points: Points;
  dimension?: number;
  segments?: Simplices;
  /** In space: each a list of corners, or of several such lines (outline, holes, segments, vertices). */
  polygons?: ReadonlyArray<ArrayLike<number> | ReadonlyArray<ArrayLike<number>>>;
  /** By the index of a polygon, a point in each of its holes. */
  polygonHoles?: Record<number, ReadonlyArray<ArrayLike<Coordinate>>>;
  /** A point in each hole of the domain. */
  holes?: Points;
  /** A point in each region that is filled; none: all that are enclosed. */
  regions?: Points;
  kind?: 'by-walls' | 'enclosed' | 'hull' | 'even-odd' | 'winding';
  mergeCoplanar?: boolean;
}

export type Claim = 'triangulation' | 'delaunay' | 'weighted-delaunay' | 'complex' | 'plc-triangulation' |
  'steiner-triangulation' | 'cdt' | 'steiner-cdt' | 'conforming-delaunay' | 'convex-hull' | 'surface-delaunay';

export interface CheckOptions {
  /** Default: 'delaunay'; with a domain 'cdt' if the mesh has its points, else 'steiner-cdt'. */
  claim?: Claim;
  domain?: Domain;
  /** How far cells of the domain may have been moved: "1e-9". */
  within?: number | string;
  weights?: ArrayLike<Coordinate>;
  /** Of flat points. */
  dimension?: number;
  /** Of a flat simplex; default: dimension + 1. */
  vertices?: number;
  /** Demand one consistent orientation. */
  oriented?: boolean;
  /** Judge by the definitions, slowly. */
  byDefinition?: boolean;
  /** Witnesses that are kept; 0 or Infinity: all. Default: 20. */
  maxViolations?: number;
  /** Take equal points for one; else they are an InputError. */
  duplicates?: 'merge';
  allowEmpty?: boolean;
  /** For the text. */
  name?: string;
  /** Demands of the claim beside it, as the command's options: "manifold", "only-extreme". */
  demands?: string | string[];
  /** What is demanded of the shape of every simplex: "min-angle:20deg". */
  require?: string | string[];
  /** Sets simplices aside that touch both sides of a sharper angle: "60deg". */
  exceptSharp?: string;
  /** Seconds after which there is an UndecidedError. */
  limit?: number;
  /** Give the verdict a `page`, one file of HTML with a picture of each witness. */
  pictures?: boolean;
}

export interface Value { exact: string; decimal: string }

/** One witness, as in the command's JSON document. Coordinates are exact texts. */
export interface Violation {
  rule: string;
  meaning: string;
  simplices: number[][];
  face?: number[];
  vertices: number[];
  coordinates: Record<string, string[]>;
  point?: string[];
  ball?: { centre: string[]; squared_radius: Value; radius_decimal?: string };
  values: Record<string, Value>;
}

export class Verdict {
  readonly holds: boolean;
  /** Of Delaunay claims that hold: is there no other such triangulation? */
  readonly unique?: boolean;
  /** Of Delaunay claims that hold: is it the one in which ties are broken canonically? */
  readonly canonical?: boolean;
  /** What the command would print: each witness, then one line. */
  readonly text: string;
  readonly notes: string[];
  /** By the name of each broken rule, how often it is broken. */
  readonly rules: Record<string, number>;
  readonly violations: Violation[];
  /** What may be all that is wrong, most first. */
  readonly causes: { cause: string; text: string; explains: number; of: number }[];
  /** The result as in the JSON document of the command. */
  readonly report: Record<string, unknown>;
  readonly page?: string;
  toString(): string;
}

/** The input is at fault, not the mesh: equal points, numbers that are not finite, a domain that is none. */
export class InputError extends Error {}
/** What was asked for does not exist. */
export class NoneError extends Error {}
/** No answer was found within the limits. */
export class UndecidedError extends Error {}

/** Judges a claim about a mesh, exactly. */
export function check(mesh: MeshLike, options?: CheckOptions): Verdict;
export function check(points: Points, simplices: Simplices, options?: CheckOptions): Verdict;

export interface Triangulation {
  /** Rows of `vertices` indices, flat. */
  simplices: Int32Array;
  vertices: number;
}
/** The canonical Delaunay triangulation of points, whatever their order: a reference, not a fast implementation. */
export function delaunay(points: Points, options?: { weights?: ArrayLike<Coordinate>; dimension?: number }): Triangulation;
/** The canonical constrained Delaunay triangulation of a domain; a NoneError if there is none. */
export function constrainedDelaunay(domain: Domain): Triangulation;

export interface Difference { same: boolean; only_in_a: { points: unknown[]; simplices: unknown[] }; only_in_b: { points: unknown[]; simplices: unknown[] } }
/** Are two meshes one complex, whatever their numbering? */
export function compare(a: MeshLike, b: MeshLike): Difference;
/** What proves a verdict to circumspect-verified. */
export function certify(mesh: MeshLike, options?: Pick<CheckOptions, 'claim' | 'dimension' | 'vertices' | 'weights'>): { holds: boolean; text: string };
/** The points that a seed stands for, flat, the same on every machine. */
export function generate(family: string, options?: { dimension?: number; count?: number; seed?: number }):
  { points: Float64Array; dimension: number; weights?: Float64Array };
/** The sign of det(p0 − pd, …): in the plane 1 if counterclockwise. */
export function orient(...points: ArrayLike<Coordinate>[]): -1 | 0 | 1;
/** Is the last point inside (1), on (0) or outside (−1) the sphere through the others? */
export function inBall(...points: ArrayLike<Coordinate>[]): -1 | 0 | 1;
export function version(): string;
