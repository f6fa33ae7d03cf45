"""Polygons as rings of coordinates: nested lists, GeoJSON, WKT, and objects that say what they are in GeoJSON."""
from __future__ import annotations

import decimal
import fractions
import json
import re
from typing import Any, Callable, Iterator, List, NamedTuple, Optional, Tuple

# What coordinates describe, and the depth of their lists: a position has 1.
POINTS, LINES, POLYGONS = "points", "lines", "polygons"
GEOMETRIES = {"Point": (POINTS, 1), "MultiPoint": (POINTS, 2), "LineString": (LINES, 2), "MultiLineString": (LINES, 3),
              "Polygon": (POLYGONS, 3), "MultiPolygon": (POLYGONS, 4)}
FURTHER_OF_WKT = {"TRIANGLE": (POLYGONS, 3), "TIN": (POLYGONS, 4), "POLYHEDRALSURFACE": (POLYGONS, 4)}
OF_WKT = {**{name.upper(): what for name, what in GEOMETRIES.items()}, **FURTHER_OF_WKT}
DEPTH_OF_ONE = {POINTS: 1, LINES: 2, POLYGONS: 3}


class Part(NamedTuple):
    """Coordinates of known depth."""

    kind: str
    depth: int
    coordinates: Any


def is_of_rings(shape: Any) -> bool:
    """Is it a text, a dictionary of GeoJSON, or an object that has one? Lists may be something else."""
    return isinstance(shape, str) or hasattr(shape, "__geo_interface__") or isinstance(shape, dict) and "type" in shape


def parts_of_rings(shape: Any, coordinates: str) -> dict:
    """The points, segments and polygons of a Domain."""
    if coordinates not in ("double", "decimal"):
        raise ValueError(f"expected coordinates='double' or coordinates='decimal', found {coordinates!r}")
    found = Vertices()
    for part in geometries_of(shape, number_of(coordinates == "decimal")):
        for one in single(part.coordinates, part.depth - DEPTH_OF_ONE[part.kind]):
            found.take(part.kind, one)
    return found.domain()


def number_of(is_decimal: bool) -> Callable[[str], Any]:
    """How a number in a text is read."""
    def read(text: str) -> Any:
        try:
            if "/" in text:
                return fractions.Fraction(text)
            return decimal.Decimal(text) if is_decimal else float(text)
        except (ValueError, ArithmeticError):
            raise ValueError(f"expected a number, found {text!r}") from None
    return read


def geometries_of(shape: Any, number: Callable[[str], Any]) -> Iterator[Part]:
    """Each geometry, whatever holds it."""
    if isinstance(shape, str):
        if shape.lstrip().startswith(("{", "[")):
            try:
                read = json.loads(shape, parse_float=number)
            except RecursionError:
                raise ValueError("expected GeoJSON, found lists or objects too deep in one another") from None
            yield from geometries_of(read, number)
        else:
            yield from of_wkt(shape, number)
        return
    shape = getattr(shape, "__geo_interface__", shape)
    if isinstance(shape, dict):
        yield from of_geojson(shape)
        return
    depth = depth_of(shape)
    if not 2 <= depth <= 4:
        raise ValueError("expected a ring, a polygon or a list of polygons, which are lists of lists of numbers, "
                         f"found lists of depth {depth}")
    yield Part(POLYGONS, max(depth, 3), [shape] if depth == 2 else shape)


def of_geojson(shape: dict) -> Iterator[Part]:
    """Features and collections of them, too."""
    waiting = [shape]
    while waiting:
        one = waiting.pop()
        if one is None:
            continue
        kind = one.get("type") if isinstance(one, dict) else one
        if kind in ("FeatureCollection", "GeometryCollection"):
            waiting += reversed(one.get("features" if kind == "FeatureCollection" else "geometries") or [])
        elif kind == "Feature":
            waiting.append(one.get("geometry"))
        elif not isinstance(kind, str) or kind not in GEOMETRIES:
            raise ValueError(f"expected one of the types {', '.join(GEOMETRIES)}, Feature, FeatureCollection, "
                             f"GeometryCollection, found {kind!r}")
        elif "coordinates" not in one:
            raise ValueError("expected the key 'coordinates', found an object without it")
        else:
            yield Part(*GEOMETRIES[kind], one["coordinates"])


TOKEN = re.compile(r"[(),;]|[^\s(),;]+")


class Words:
    """The tokens of a text of WKT."""

    def __init__(self, text: str):
        self.tokens = [(match.group(), match.start()) for match in TOKEN.finditer(text)]
        self.text, self.next = text, 0

    def word(self) -> str:
        """The current one in capital letters; empty at the end."""
        return self.tokens[self.next][0].upper() if self.next < len(self.tokens) else ""

    def take(self, *words: str) -> bool:
        """Goes on if the current one is among these."""
        is_there = self.word() in words and bool(self.word())
        self.next += is_there
        return is_there

    def fail(self, expected: str) -> ValueError:
        """With the line."""
        place = self.tokens[self.next][1] if self.next < len(self.tokens) else len(self.text)
        found = repr(self.tokens[self.next][0]) if self.next < len(self.tokens) else "the end of the text"
        return ValueError(f"line {self.text.count(chr(10), 0, place) + 1} of WKT: expected {expected}, found {found}")


def of_wkt(text: str, number: Callable[[str], Any]) -> Iterator[Part]:
    """One geometry or several, with or without commas between them."""
    words, collections = Words(text), 0
    while words.word():
        if words.word().startswith("SRID="):
            words.next += 1
        elif collections and words.take(")"):
            collections -= 1
        elif words.take(",", ";"):
            continue
        elif re.fullmatch("GEOMETRYCOLLECTION(Z|M|ZM)?", words.word()):
            words.next += 1
            words.take("Z", "M", "ZM")
            if not words.take("EMPTY") and not words.take("("):
                raise words.fail("'(' or EMPTY")
            collections += words.tokens[words.next - 1][0] == "("
        else:
            yield geometry_of_wkt(words, number)
    if collections:
        raise words.fail("')' after a collection")


def geometry_of_wkt(words: Words, number: Callable[[str], Any]) -> Part:
    """A geometry, and the columns of its positions: as they are listed, or z, m or both are announced."""
    match = re.fullmatch(f"({'|'.join(OF_WKT)})(ZM|Z|M)?", words.word())
    if not match:
        raise words.fail("a geometry of straight lines, such as POLYGON or MULTIPOLYGON")
    words.next += 1
    columns = match.group(2) or ""
    if not columns and words.take("Z", "M", "ZM"):
        columns = words.tokens[words.next - 1][0].upper()
    kind, depth = OF_WKT[match.group(1)]
    return Part(kind, depth, list_of_wkt(words, depth, columns, number))


def list_of_wkt(words: Words, depth: int, columns: str, number: Callable[[str], Any]) -> list:
    """What is in parentheses; a position stands in none unless it is a point."""
    if words.take("EMPTY"):
        return []
    in_parentheses = words.take("(")
    if depth > 1 and not in_parentheses:
        raise words.fail("'(' or EMPTY")
    parts: list = []
    if depth == 1:
        while words.word() not in ("", "(", ")", ",", ";"):
            try:
                parts.append(number(words.tokens[words.next][0]))
            except ValueError:
                raise words.fail("a number") from None
            words.next += 1
        wanted = 2 + len(columns) if columns else len(parts)
        if len(parts) != wanted or not 2 <= len(parts) <= 4:
            raise words.fail(f"{wanted if columns else '2 or 3'} coordinates of a position")
        parts = parts[:-1] if "M" in columns else parts
    else:
        parts.append(list_of_wkt(words, depth - 1, columns, number))
        while words.take(","):
            parts.append(list_of_wkt(words, depth - 1, columns, number))
    if in_parentheses and not words.take(")"):
        raise words.fail("',' or ')'")
    return parts


def listed(value: Any) -> Optional[list]:
    """A list of whatever is one, None of a number."""
    value = value.tolist() if hasattr(value, "tolist") else value
    return list(value) if isinstance(value, (list, tuple)) else None


def depth_of(value: Any) -> int:
    """Of lists in lists."""
    depth, inner = 0, listed(value)
    while inner is not None and depth < 5:  # a list may hold itself
        depth += 1
        inner = listed(inner[0]) if inner else None
    return depth


def single(coordinates: Any, levels: int) -> Iterator[Any]:
    """Each polygon, line or position of a list of them."""
    if levels == 0:
        yield coordinates
        return
    inner = listed(coordinates)
    if inner is None:
        raise TypeError(f"expected a list of coordinates, found {coordinates!r}")
    for one in inner:
        yield from single(one, levels - 1)


class Vertices:
    """Positions, each once, and what uses them."""

    def __init__(self) -> None:
        self.place: dict = {}
        self.lines: List[List[int]] = []
        self.polygons: List[List[List[int]]] = []

    def vertex(self, position: Any) -> int:
        """The index of a position."""
        numbers = listed(position)
        if numbers is None or not 2 <= len(numbers) <= 3 or any(listed(number) is not None for number in numbers):
            raise ValueError(f"expected a position of 2 or 3 numbers, found {position!r}")
        first = next(iter(self.place), numbers)
        if len(numbers) != len(first):
            raise ValueError(f"expected {len(first)} coordinates, as the first position has, found {position!r}")
        return self.place.setdefault(tuple(numbers), len(self.place))

    def line(self, positions: Any) -> List[int]:
        """A line without corners that repeat the one before."""
        corners: List[int] = []
        for position in single(positions, 1):
            corner = self.vertex(position)
            if not corners or corners[-1] != corner:
                corners.append(corner)
        return corners

    def take(self, kind: str, coordinates: Any) -> None:
        """A position, a line or a polygon."""
        if kind == POINTS:
            if listed(coordinates):
                self.vertex(coordinates)
        elif kind == LINES:
            self.lines.append(self.line(coordinates))
        else:
            rings = [self.line(ring) for ring in single(coordinates, 1)]
            for ring in rings:
                while len(ring) > 1 and ring[0] == ring[-1]:
                    ring.pop()
                if len(ring) < 3:
                    raise ValueError(f"expected a ring of at least 3 points, found {len(ring)}")
            if rings:
                self.polygons.append(rings)

    def domain(self) -> dict:
        """In the plane if the third coordinate is the same for all."""
        if not self.place:
            raise ValueError("expected polygons, lines or points, found none")
        points: List[Tuple] = list(self.place)
        if len(points[0]) == 3 and all(point[2] == points[0][2] for point in points):
            points = [point[:2] for point in points]
        if len(points[0]) == 3 and any(len(rings) > 1 for rings in self.polygons):
            raise ValueError("expected polygons of one ring where the third coordinate differs, found more rings; in space, "
                             "Domain takes polygon_holes")
        segments = [list(pair) for line in self.lines for pair in zip(line, line[1:])]
        return {"points": [list(point) for point in points], "segments": segments, "polygons": self.polygons}
