"""Hunting for mistakes in a Python function that triangulates, in this process or in one beside it."""
from __future__ import annotations

import copy
import faulthandler
import inspect as signatures
import time as clocks
import traceback
from pathlib import Path
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Tuple

from . import _core
from .domains import Domain, distinct_rows, in_plane_of
from .meshes import Mesh, guarded, indices_of, merges, mesh_of, number_text, parts_of, points_of
from .verdicts import Verdict

CLAIMS = ("triangulation", "delaunay", "weighted-delaunay")
CLAIMS_OF_DOMAINS = ("plc-triangulation", "steiner-triangulation", "cdt", "steiner-cdt", "conforming-delaunay")

# Binary exponents of coordinates, as the command's campaigns draw them: few programs promise more.
EXPONENTS = (-100, 100)

# Minimizing ends after so many calls, or when its share of the time is over.
MOST_TRIES = 20_000


class Finding(NamedTuple):
    """An input on which the function is wrong, made small."""

    rule: str  # the rule that is broken; or "raised", "no-mesh", "other-points", "hang", "crash"
    points: Any  # (n, d) doubles, the smallest found that breaks the same rule
    weights: Any
    simplices: Any  # what the function made of them, or None
    report: str  # for people: the witness, or the traceback
    family: str = ""
    seed: int = 0  # generate(family, dimension=..., points=..., seed=..., fewer=True) makes the original, before its
    # exponents were brought into their range
    original: Any = None
    domain: Optional[Domain] = None  # whose points these are; generate_domain(family, points=..., seed=...) makes the
    # original

    def __str__(self) -> str:
        rows = [f"  {index} {' '.join(map(repr, row))}" for index, row in enumerate(self.points.tolist())]
        size = f"{len(self.points)} points"
        if self.domain is not None:
            size, rows = self.domain.size(), [_core.poly_text(self.domain.lists()).rstrip()]
        listed = "\n".join(rows)
        return f"{self.rule} on {size}:\n{listed}\n{self.report}".rstrip()


class Campaign(NamedTuple):
    """The result of a campaign; true if it found nothing."""

    cases: int
    findings: List[Finding]
    seconds: float

    def __bool__(self) -> bool:
        return not self.findings

    def __str__(self) -> str:
        found = "\n\n".join(map(str, self.findings))
        summary = f"campaign: {self.cases} cases, {len(self.findings)} findings in {self.seconds:.1f} s"
        return f"{found}\n\n{summary}" if found else summary

    def raise_for_failure(self) -> "Campaign":
        """Raises AssertionError if there are findings."""
        if self.findings:
            raise AssertionError(str(self))
        return self


class Outcome(NamedTuple):
    """The outcome of one call: an empty rule if all is well."""

    rule: str
    report: str = ""
    simplices: Any = None


class Case(NamedTuple):
    """An input: (n, d) points and weights, or a domain."""

    points: Any
    weights: Any = None
    domain: Optional[Domain] = None


class Subject:
    """The function under test, called in this process."""

    def __init__(self, function: Callable, claim: str, refuses: Tuple[type, ...] = (), within: Optional[str] = None,
                 merge: bool = False):
        self.function, self.claim, self.refuses, self.within, self.merge = function, claim, refuses, within, merge
        self.takes_weights = claim == "weighted-delaunay"

    def call(self, case: Case) -> Any:
        """Passes copies, because the function may change its arguments."""
        if case.domain is not None:
            return self.function(Domain.of_lists(copy.deepcopy(case.domain.lists())))
        own = case.points.copy()
        return self.function(own, case.weights.copy()) if self.takes_weights else self.function(own)

    def answer(self, case: Case) -> Tuple[str, Any]:
        """("mesh", its Mesh), ("refused", None), or a rule and a report."""
        try:
            made = self.call(case)
        except self.refuses:
            return "refused", None
        except (Exception, SystemExit):  # whatever a mesher raises is a finding
            return "raised", traceback.format_exc(limit=-3)
        try:
            if case.domain is not None:
                return "mesh", mesh_on(case.domain, made)
            # A mesh object is judged with the points that were given, not with those that it may
            # have changed.
            simplices = parts_of(made)[1] if not hasattr(made, "__array__") and hasattr(made, "__dict__") else made
            return "mesh", mesh_of(case.points, simplices, None, case.weights)
        except Exception as error:  # rubbish may be of any kind
            return "no-mesh", str(error)

    def outcome(self, case: Case) -> Outcome:
        """The call, judged."""
        kind, value = self.answer(case)
        if kind == "refused":
            return Outcome("")
        if kind != "mesh":
            return Outcome(kind, value)
        about = None if case.domain is None else case.domain.parts()
        try:
            # An input always has points, so an empty mesh is wrong, and not a fault of the input.
            verdict = Verdict(_core.check(self.claim, guarded(value).parts(), about, 1, 3, False, False, self.merge,
                                          True, self.within, "", "mesh", 0, True))
        except _core.Undecided:
            return Outcome("")
        except _core.InputError as error:
            if len(distinct_rows(value.points)) == value.points.shape[0]:
                raise
            return Outcome("other-points", str(error))  # those of the input differ
        return Outcome("") if verdict else Outcome(next(iter(verdict.rules)), str(verdict), value.simplices)

    def close(self) -> None:
        """Nothing to end."""


class IsolatedSubject(Subject):
    """The same in a forked process, which may crash or hang. It serves many calls and is replaced if it ends."""

    def __init__(self, *arguments: Any, time_limit: float):
        import multiprocessing  # a twentieth of a second

        super().__init__(*arguments)
        self.time_limit = time_limit
        self.context = multiprocessing.get_context("fork")
        self.process: Any = None
        self.connection: Any = None

    def serve(self, connection: Any) -> None:
        """In the child."""
        faulthandler.disable()  # the parent reports how the child ended
        while True:
            try:
                case = connection.recv()
            except EOFError:
                return
            connection.send(super().answer(case))

    def start(self) -> None:
        """Forks a process."""
        self.connection, others = self.context.Pipe()
        self.process = self.context.Process(target=self.serve, args=(others,), daemon=True)
        self.process.start()
        others.close()

    def answer(self, case: Case) -> Tuple[str, Any]:
        if self.process is None:
            self.start()
        try:
            self.connection.send(case)
            if not self.connection.poll(self.time_limit):
                self.close()
                return "hang", f"no answer within {self.time_limit:g} s"
            return self.connection.recv()
        except (EOFError, OSError):
            self.process.join(1)
            code = self.process.exitcode
            self.close()
            how = f"signal {-code}" if code is not None and code < 0 else f"exit code {code}"
            return "crash", f"the process ended by {how}"

    def close(self) -> None:
        if self.process is not None:
            self.process.kill()
            self.process.join()
            self.connection.close()
            self.process = None


def mesh_on(domain: Domain, made: Any) -> Mesh:
    """What a function made of a domain: simplices of its points, (points, simplices), or a mesh object."""
    import numpy as np

    triangles = edges = None
    if isinstance(made, tuple) and len(made) == 2 and np.ndim(made[0]) == 2:
        points, simplices = made
    elif hasattr(made, "simplices") and not hasattr(made, "points"):  # Constrained
        points, simplices = domain.points, made.simplices
        triangles, edges = getattr(made, "triangles", None), getattr(made, "edges", None)
    elif not hasattr(made, "__array__") and hasattr(made, "__dict__"):
        points, simplices, _, triangles, edges = parts_of(made)
    else:
        points, simplices = domain.points, made
    mesh = in_plane_of(mesh_of(points, simplices), domain)
    if mesh.dimension != domain.dimension:
        raise ValueError(f"expected points of {domain.dimension} coordinates, as those of the domain, "
                         f"found {mesh.dimension}")
    faces = [None if rows is None else indices_of(rows, what, size).astype(np.int64)
             for rows, what, size in ((triangles, "triangles", 3), (edges, "edges", 2))]
    return mesh._replace(triangles=faces[0], edges=faces[1])


def subject_of(function: Callable, claim: Optional[str], domains: bool, refuses: Sequence[type], isolated: bool,
               time_limit: float, within: Any, duplicates: str) -> Subject:
    """The function, called here or in a process of its own."""
    if not callable(function):
        raise TypeError(f"expected a function that takes points and returns simplices, found {function!r}")
    known = CLAIMS_OF_DOMAINS if domains else CLAIMS
    claim = claim or ("cdt" if domains else "delaunay")
    if claim not in known:
        raise ValueError(f"expected the claim {', '.join(known[:-1])} or {known[-1]}, found {claim!r}")
    if within is not None and not domains:
        raise ValueError("expected domains beside within, found points")
    kinds = tuple(refuses) if isinstance(refuses, (tuple, list, set)) else (refuses,)
    if not all(signatures.isclass(kind) and issubclass(kind, BaseException) for kind in kinds):
        raise TypeError(f"expected exception types as refuses, found {refuses!r}")
    distance = None if within is None else number_text(within, "a distance")
    merge = merges(duplicates)
    if isolated:
        return IsolatedSubject(function, claim, kinds, distance, merge, time_limit=time_limit)
    return Subject(function, claim, kinds, distance, merge)


def made_small(subject: Subject, case: Case, rule: str, flat: bool, seconds: float) -> Case:
    """The smallest input found on which the same rule is broken."""
    def still_fails(fewer: Any, of_fewer: Any) -> bool:
        return is_wanted(fewer, flat) and subject.outcome(Case(fewer, of_fewer)).rule == rule

    def of_domain(lists: tuple) -> bool:
        return subject.outcome(domain_case(lists)).rule == rule

    if case.domain is not None:
        return domain_case(_core.minimized_domain(case.domain.lists(), of_domain, MOST_TRIES, seconds))
    return Case(*_core.minimized(case.points, case.weights, still_fails, MOST_TRIES, seconds))


def domain_case(lists: tuple) -> Case:
    """A case of the lists that `_core` draws."""
    domain = Domain.of_lists(lists)
    return Case(domain.points, None, domain)


def require_distinct(families: Sequence[str]) -> None:
    """Families that repeat points need duplicates="merge"."""
    repeating = {family for family, _, _, _, repeats in _core.families() if repeats}
    for family in families:
        if family in repeating:
            raise ValueError(f"expected duplicates='merge' beside the family {family!r}, which repeats points, found "
                             "'reject'")


def is_wanted(points: Any, flat: bool) -> bool:
    """Points that span less than their space are left out unless `flat`."""
    import numpy as np

    if flat:
        return True
    dimension = points.shape[1]
    if len(points) <= dimension:
        return False
    # Doubles usually prove quickly that the points span space: the least singular value is not 0 if
    # it is a million times what rounding can make of 0. Otherwise the exact answer is asked for.
    edges = points[1:] - points[0]
    if np.isfinite(edges).all() and np.linalg.matrix_rank(edges) == dimension:
        scale = np.abs(edges).max()
        if scale > 0 and np.linalg.svd(edges / scale, compute_uv=False)[dimension - 1] > 1e-9:
            return True
    return len(np.unique(points, axis=0)) > dimension and _core.delaunay(
        mesh_of(np.unique(points, axis=0), np.zeros((0, dimension + 1), int)).parts()).shape[1] == dimension + 1


def minimize(function: Callable, points: Any, *, claim: Optional[str] = None, weights: Any = None,
             refuses: Sequence[type] = (), isolated: bool = False, time_limit: float = 10.0, flat: bool = True,
             time: float = 60.0, within: Any = None, duplicates: str = "reject") -> Finding:
    """The smallest (n, d) points found on which a function is wrong in the same way as on these.

    `function(points)` (with weights: `function(points, weights)`) returns simplices, or a mesh object. Instead of
    points, pass a Domain to test `function(domain)`. `duplicates`: as in `campaign`. Raises ValueError if the
    function is right on it, or if numbers do not fit doubles; TypeError for what is not a number; and InputError if
    points are equal, unless they are to be merged.
    """
    import numpy as np

    if isinstance(points, Domain):
        given = domain_case(points.lists())
        # An input that is not a piecewise linear complex is refused here, before the function is
        # called.
        _core.check("plc-triangulation", points_of(given.points).parts(), points.parts(), 1, 1, False, False, False,
                    False, None, "", "", 0, True)
    else:
        points_of(points, weights)  # refuses what check refuses
        try:
            own = np.array(points, dtype=np.float64)
            own_weights = None if weights is None else np.array(weights, dtype=np.float64)
        except OverflowError:
            raise ValueError("expected points and weights within the range of double") from None
        given = Case(own, own_weights)
    subject = subject_of(function, claim, given.domain is not None, refuses, isolated, time_limit, within, duplicates)
    if given.domain is None and not subject.merge:
        _core.check("triangulation", points_of(given.points).parts(), None, 1, 1, False, False, False, True, None, "", "", 0,
                    True)  # equal points are refused here
    try:
        rule = subject.outcome(given).rule
        if not rule:
            raise ValueError("expected points on which the function is wrong, found that it is right on them")
        return small_finding(subject, rule, "", 0, given, flat=flat, seconds=time)
    finally:
        subject.close()


def campaign(function: Callable, *, time: float = 10.0, cases: Optional[int] = None, dimension: int = 3,
             claim: Optional[str] = None, families: Sequence[str] = (), points: int = 20, seed: int = 20260101,
             flat: bool = False, refuses: Sequence[type] = (), isolated: bool = False, time_limit: float = 10.0,
             save: Any = None, domains: bool = False, within: Any = None, duplicates: str = "reject",
             exponents: Optional[Tuple[int, int]] = EXPONENTS) -> Campaign:
    """Hunts for inputs on which a function is wrong, for `time` seconds or for a number of `cases`.

    function(points): from (n, d) doubles to (m, d+1) integers, or to a mesh object such as
        scipy.spatial.Delaunay. For "weighted-delaunay", function(points, weights). An exception is a finding, unless
        its type is among `refuses`; so is a result that is not a mesh.
    domains: draws domains. function(domain) then gets a Domain, with `points`, `segments`, `polygons` and `holes`. It
        returns simplices, (points, simplices) if it adds points, or a mesh object.
    claim: "delaunay" (the default), "triangulation", "weighted-delaunay"; of domains "cdt" (the default),
        "plc-triangulation", "steiner-triangulation", "steiner-cdt" or "conforming-delaunay". Not every domain has a
        CDT: a function that detects this should raise a type in `refuses`.
    within: how far cells of the domain may be moved, as in `check`; rounded points need it.
    families: names (see circumspect.families); none: all of the dimension whose points are distinct. Those that repeat
        points need duplicates="merge".
    duplicates: "merge" counts equal points as one, as in `check`; otherwise equal points that the function adds are a
        finding.
    exponents: coordinates other than 0 lie between these powers of 2; points beyond are scaled or compressed. None: as
        the family draws them, up to 1e300. Domains are as they are drawn.
    flat: also points that span only a flat, where rows of k+1 indices are the answer.
    isolated: calls it in a forked process, so that a crash, or a call longer than `time_limit`, is a finding.
    save: a folder for the findings, one .npy and one .txt each; of domains a .poly too.

    Returns one finding for each rule, with its input made small; minimizing takes up to `time` again.

    >>> found = campaign(lambda points: [[0, 1, 2]], dimension=2, cases=50)
    >>> bool(found), found.findings[0].rule
    (False, 'triangulation.unused-point')
    """
    subject = subject_of(function, claim, domains, refuses, isolated, time_limit, within, duplicates)
    if not subject.merge and not domains:
        require_distinct(families)
    start = clocks.monotonic()
    found: List[Tuple[str, str, int, Case]] = []
    seen = set()
    count = 0
    try:
        while count < cases if cases is not None else clocks.monotonic() - start < time:
            if domains:
                family, drawn_seed, lists = _core.drawn_domain_case(list(families), dimension, points, seed, count)
                case = domain_case(lists)
            else:
                family, drawn_seed, *drawn = _core.drawn_case(list(families), dimension, subject.takes_weights, points,
                                                              seed, count)
                case = Case(*within_exponents(*drawn, exponents))
            count += 1
            # A hull has to span its space.
            if not len(case.points) or not is_wanted(case.points, case.domain.kind != "hull" if domains else flat):
                continue
            if subject.takes_weights and case.weights is None:
                continue
            rule = subject.outcome(case).rule
            if rule and rule not in seen:
                seen.add(rule)
                found.append((rule, family, drawn_seed, case))
        findings = [small_finding(subject, *one, flat=flat, seconds=time / len(found)) for one in found]
    finally:
        subject.close()
    if save is not None:
        save_findings(Path(save), findings)
    return Campaign(count, findings, clocks.monotonic() - start)


def within_exponents(points: Any, weights: Any, exponents: Optional[Tuple[int, int]]) -> tuple:
    """Points and weights with their exponents in a range. Distinct points stay distinct."""
    import numpy as np

    if exponents is None or not len(points):
        return points, weights
    least, largest = exponents
    if not -1074 <= least < largest <= 1023:
        raise ValueError(f"expected two exponents of doubles, the lower first, found {exponents!r}")
    repeats = len(np.unique(points, axis=0)) < len(points)
    return _core.brought_within(points, weights, least, largest, repeats)


def small_finding(subject: Subject, rule: str, family: str, seed: int, case: Case, *, flat: bool,
                  seconds: float) -> Finding:
    """A case made small."""
    small = made_small(subject, case, rule, flat, seconds)
    outcome = subject.outcome(small)
    return Finding(rule, small.points, small.weights, outcome.simplices, outcome.report, family, seed,
                   case.points if case.domain is None else case.domain, small.domain)


def save_findings(folder: Path, findings: Sequence[Finding]) -> None:
    """One .npy file with the points and one .txt file with the report each; of a domain a .poly file too."""
    import numpy as np

    folder.mkdir(parents=True, exist_ok=True)
    for number, finding in enumerate(findings, 1):
        stem = f"{number:02d}-{finding.rule}"
        np.save(folder / f"{stem}.npy", finding.points)
        if finding.domain is not None:
            (folder / f"{stem}.poly").write_text(_core.poly_text(finding.domain.lists()), encoding="utf-8")
        (folder / f"{stem}.txt").write_text(f"{finding}\n", encoding="utf-8")
