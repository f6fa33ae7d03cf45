"""Hunting for mistakes in a Python function that triangulates, in this process or in one beside it."""
from __future__ import annotations

import faulthandler
import inspect as signatures
import multiprocessing
import time as clocks
import traceback
from pathlib import Path
from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Tuple

from . import _core
from .meshes import mesh_of, parts_of
from .verdicts import Verdict

# Minimizing ends after so many calls, or when its share of the time is over.
MOST_TRIES = 20_000


class Finding(NamedTuple):
    """An input on which the function is wrong, made small."""

    rule: str  # the rule that is broken; or "raised", "no-mesh", "hang", "crash"
    points: Any  # (n, d) doubles, the smallest found that breaks the same rule
    weights: Any
    simplices: Any  # what the function made of them, or None
    report: str  # for people: the witness, or the traceback
    family: str = ""
    seed: int = 0  # generate(family, dimension=..., points=..., seed=..., fewer=True) makes the original
    original: Any = None

    def __str__(self) -> str:
        rows = "\n".join(f"  {index} {' '.join(map(repr, row))}" for index, row in enumerate(self.points.tolist()))
        return f"{self.rule} on {len(self.points)} points:\n{rows}\n{self.report}".rstrip()


class Campaign(NamedTuple):
    """What a campaign came to; true if it found nothing."""

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
    """What became of one call: an empty rule if all is well."""

    rule: str
    report: str = ""
    simplices: Any = None


class Subject:
    """The function under test, called in this process."""

    def __init__(self, function: Callable, claim: str, refuses: Tuple[type, ...] = ()):
        self.function, self.claim, self.refuses = function, claim, refuses
        self.takes_weights = claim == "weighted-delaunay"

    def answer(self, points: Any, weights: Any) -> Tuple[str, Any]:
        """("mesh", simplices), ("refused", None), or a rule and a report."""
        own = points.copy()  # the function may change what it is given
        try:
            made = self.function(own, weights.copy()) if self.takes_weights else self.function(own)
        except self.refuses:
            return "refused", None
        except (Exception, SystemExit):  # whatever a mesher raises is a finding
            return "raised", traceback.format_exc(limit=-3)
        try:
            # A mesh object is judged by the points that were given, not by those it may have changed.
            simplices = parts_of(made)[1] if not hasattr(made, "__array__") and hasattr(made, "__dict__") else made
            return "mesh", mesh_of(points, simplices).simplices
        except Exception as error:  # rubbish may be of any kind
            return "no-mesh", str(error)

    def outcome(self, points: Any, weights: Any) -> Outcome:
        """The call, judged."""
        kind, value = self.answer(points, weights)
        if kind == "refused":
            return Outcome("")
        if kind != "mesh":
            return Outcome(kind, value)
        mesh = mesh_of(points, value, None, weights)
        verdict = Verdict(self.claim, _core.check(self.claim, mesh.parts(), None, 1, 3, False, False, None, "mesh", False))
        return Outcome("") if verdict else Outcome(next(iter(verdict.rules)), str(verdict), value)

    def close(self) -> None:
        """Nothing to end."""


class IsolatedSubject(Subject):
    """The same in a forked process, which may crash or hang; it serves many calls and is replaced if it ends."""

    def __init__(self, *arguments: Any, time_limit: float):
        super().__init__(*arguments)
        self.time_limit = time_limit
        self.context = multiprocessing.get_context("fork")
        self.process: Any = None
        self.connection: Any = None

    def serve(self, connection: Any) -> None:
        """In the child."""
        faulthandler.disable()  # what ends it is told by the parent
        while True:
            try:
                points, weights = connection.recv()
            except EOFError:
                return
            connection.send(super().answer(points, weights))

    def start(self) -> None:
        """Forks a process."""
        self.connection, others = self.context.Pipe()
        self.process = self.context.Process(target=self.serve, args=(others,), daemon=True)
        self.process.start()
        others.close()

    def answer(self, points: Any, weights: Any) -> Tuple[str, Any]:
        if self.process is None:
            self.start()
        try:
            self.connection.send((points, weights))
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


def subject_of(function: Callable, claim: str, refuses: Sequence[type], isolated: bool, time_limit: float) -> Subject:
    """The function, called here or in a process of its own."""
    if not callable(function):
        raise TypeError(f"expected a function that takes points and returns simplices, found {function!r}")
    if claim not in ("triangulation", "delaunay", "weighted-delaunay"):
        raise ValueError(f"expected the claim triangulation, delaunay or weighted-delaunay, found {claim!r}")
    kinds = tuple(refuses) if isinstance(refuses, (tuple, list, set)) else (refuses,)
    if not all(signatures.isclass(kind) and issubclass(kind, BaseException) for kind in kinds):
        raise TypeError(f"expected exception types as refuses, found {refuses!r}")
    if isolated:
        return IsolatedSubject(function, claim, kinds, time_limit=time_limit)
    return Subject(function, claim, kinds)


def made_small(subject: Subject, points: Any, weights: Any, rule: str, flat: bool, seconds: float):
    """The smallest points found on which the same rule is broken."""
    def still_fails(fewer: Any, of_fewer: Any) -> bool:
        return is_wanted(fewer, flat) and subject.outcome(fewer, of_fewer).rule == rule

    return _core.minimized(points, weights, still_fails, MOST_TRIES, seconds)


def is_wanted(points: Any, flat: bool) -> bool:
    """Points that span less than their space are left out unless `flat`."""
    import numpy as np

    if flat:
        return True
    dimension = points.shape[1]
    if len(points) <= dimension:
        return False
    # Doubles say quickly that the points span space: where the least singular value is a million times what rounding
    # can make of 0, it is none. Where they do not say so the exact answer is asked for.
    edges = points[1:] - points[0]
    if np.isfinite(edges).all() and np.linalg.matrix_rank(edges) == dimension:
        scale = np.abs(edges).max()
        if scale > 0 and np.linalg.svd(edges / scale, compute_uv=False)[dimension - 1] > 1e-9:
            return True
    return len(np.unique(points, axis=0)) > dimension and _core.delaunay(
        mesh_of(np.unique(points, axis=0), np.zeros((0, dimension + 1), int)).parts()).shape[1] == dimension + 1


def minimize(function: Callable, points: Any, *, claim: str = "delaunay", weights: Any = None,
             refuses: Sequence[type] = (), isolated: bool = False, time_limit: float = 10.0, flat: bool = True,
             time: float = 60.0) -> Finding:
    """The smallest (n, d) points found on which a function is wrong in the same way as on these.

    `function(points)` (with weights: `function(points, weights)`) returns simplices, or a mesh object. Raises
    ValueError if it is right on the points that are given.
    """
    import numpy as np

    own = np.array(points, dtype=np.float64)
    if own.ndim != 2 or not np.isfinite(own).all():
        raise ValueError(f"expected finite points of shape (n, d), found {own.shape}")
    heavy = None if weights is None else np.array(weights, dtype=np.float64)
    subject = subject_of(function, claim, refuses, isolated, time_limit)
    try:
        rule = subject.outcome(own, heavy).rule
        if not rule:
            raise ValueError("expected points on which the function is wrong, found that it is right on them")
        small, of_small = made_small(subject, own, heavy, rule, flat, time)
        outcome = subject.outcome(small, of_small)
    finally:
        subject.close()
    return Finding(rule, small, of_small, outcome.simplices, outcome.report, original=own)


def campaign(function: Callable, *, time: float = 10.0, cases: Optional[int] = None, dimension: int = 3,
             claim: str = "delaunay", families: Sequence[str] = (), points: int = 20, seed: int = 20260101,
             flat: bool = False, refuses: Sequence[type] = (), isolated: bool = False, time_limit: float = 10.0,
             save: Any = None) -> Campaign:
    """Hunts for inputs on which a function is wrong, for `time` seconds or for a number of `cases`.

    function(points): from (n, d) doubles to (m, d+1) integers, or to a mesh object such as
        scipy.spatial.Delaunay. For "weighted-delaunay", function(points, weights). What it raises is a finding,
        unless its type is among `refuses`; so is anything that is no mesh.
    families: names (see circumspect.families); none: all of the dimension whose points are distinct.
    flat: also points that span only a flat, where rows of k+1 indices are the answer.
    isolated: calls it in a forked process, so that a crash, or a call longer than `time_limit`, is a finding.
    save: a folder for the findings, one .npy and one .txt each.

    One finding for each rule, its input made small; that takes up to `time` again.

    >>> found = campaign(lambda points: [[0, 1, 2]], dimension=2, cases=50)
    >>> bool(found), found.findings[0].rule
    (False, 'triangulation.unused-point')
    """
    subject = subject_of(function, claim, refuses, isolated, time_limit)
    start = clocks.monotonic()
    found: List[Tuple[str, str, int, Any, Any]] = []
    seen = set()
    count = 0
    try:
        while count < cases if cases is not None else clocks.monotonic() - start < time:
            family, drawn_seed, drawn, weights = _core.drawn_case(list(families), dimension,
                                                                  claim == "weighted-delaunay", points, seed, count)
            count += 1
            if not len(drawn) or not is_wanted(drawn, flat):
                continue
            if subject.takes_weights and weights is None:
                continue
            rule = subject.outcome(drawn, weights).rule
            if rule and rule not in seen:
                seen.add(rule)
                found.append((rule, family, drawn_seed, drawn, weights))
        findings = [small_finding(subject, *case, flat=flat, seconds=time / len(found)) for case in found]
    finally:
        subject.close()
    if save is not None:
        save_findings(Path(save), findings)
    return Campaign(count, findings, clocks.monotonic() - start)


def small_finding(subject: Subject, rule: str, family: str, seed: int, drawn: Any, weights: Any, *, flat: bool,
                  seconds: float) -> Finding:
    """A case made small."""
    small, of_small = made_small(subject, drawn, weights, rule, flat, seconds)
    outcome = subject.outcome(small, of_small)
    return Finding(rule, small, of_small, outcome.simplices, outcome.report, family, seed, drawn)


def save_findings(folder: Path, findings: Sequence[Finding]) -> None:
    """One .npy file with the points and one .txt file with the report each."""
    import numpy as np

    folder.mkdir(parents=True, exist_ok=True)
    for number, finding in enumerate(findings, 1):
        stem = f"{number:02d}-{finding.rule}"
        np.save(folder / f"{stem}.npy", finding.points)
        (folder / f"{stem}.txt").write_text(f"{finding}\n", encoding="utf-8")
