"""Verdicts and their witnesses."""
from __future__ import annotations

import fractions
import json
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

from .drawing import picture_of

Fraction = fractions.Fraction
MOST_PICTURES = 3
LARGEST_SHOWN = 60000  # characters of HTML; notebooks keep a copy


class Ball(NamedTuple):
    """A circumball; for weighted points the squared radius may be negative."""

    centre: Tuple[Fraction, ...]
    squared_radius: Fraction


class Violation(NamedTuple):
    """One witness: vertices are indices of points, and values are exact."""

    rule: str  # "delaunay.facet-not-local": never changes its meaning
    meaning: str
    simplices: List[List[int]]
    face: Optional[List[int]]
    vertices: List[int]
    values: Dict[str, Fraction]
    ball: Optional[Ball]
    point: Optional[Tuple[Fraction, ...]]


class CheckFailed(AssertionError):
    """A claim does not hold; `verdict` says why."""

    def __init__(self, verdict: "Verdict"):
        super().__init__(str(verdict).rstrip())
        self.verdict = verdict


def point_of(texts: List[str]) -> Tuple[Fraction, ...]:
    """Exact coordinates."""
    return tuple(Fraction(text) for text in texts)


class Verdict:
    """The answer to a claim: true if it holds, and `print` shows what the command prints.

    >>> import circumspect
    >>> verdict = circumspect.check([[0, 0], [1, 0], [0, 1], [0.9, 0.9]], [[0, 1, 2], [1, 3, 2]])
    >>> bool(verdict), verdict.rules
    (False, {'delaunay.facet-not-local': 1})
    >>> verdict.violations[0].vertices, verdict.violations[0].ball.squared_radius
    ([3], Fraction(1, 2))
    """

    def __init__(self, parts: tuple):
        self.claim: str
        self.holds: bool
        self.notes: List[str]  # what was judged differently from what was passed in
        self.claim, self.holds, unique, canonical, self.text, self.json, rules, self.notes, self._page = parts
        self.rules: Dict[str, int] = rules  # the broken ones, and how often each is
        # For a Delaunay claim that holds: is it the only triangulation, is it the canonical one?
        # Else None.
        self.unique: Optional[bool] = None if unique < 0 else bool(unique)
        self.canonical: Optional[bool] = None if canonical < 0 else bool(canonical)

    def __getstate__(self) -> dict:
        return {**self.__dict__, "_page": None}  # rendered only when asked for

    def __bool__(self) -> bool:
        return self.holds

    def __str__(self) -> str:
        return "\n".join([*(f"note: {note}" for note in self.notes), self.text.rstrip("\n")])

    def __repr__(self) -> str:
        return f"<Verdict {self.text.splitlines()[-1]}>"

    def to_dict(self) -> dict:
        """The result of the command's JSON document, whose keys docs/json.md explains."""
        return json.loads(self.json)["results"][0]

    @property
    def violations(self) -> List[Violation]:
        """The witnesses, at most `max_errors` of them."""
        return [violation_of(entry) for entry in self.to_dict()["violations"]]

    @property
    def causes(self) -> List[dict]:
        """What may be all that is wrong, most first: `cause`, `text`, and how many of how many violations it `explains`."""
        return self.to_dict().get("causes", [])

    def raise_for_failure(self) -> "Verdict":
        """Raises CheckFailed, an AssertionError, if the claim does not hold."""
        if not self.holds:
            raise CheckFailed(self)
        return self

    def to_html(self) -> str:
        """The page that `circumspect check --html` writes, with a picture of each witness. The page loads nothing.

        Raises ValueError for a verdict that was pickled, which leaves its pictures behind.
        """
        if self._page is None:
            raise ValueError("expected a verdict of this process, found one that was pickled, which has no pictures")
        return self._page()

    def _repr_html_(self) -> str:
        import html

        colour = "#1a7f37" if self.holds else "#cf222e"
        lines, last = str(self)[:LARGEST_SHOWN // 8], self.text.splitlines()[-1]
        if len(lines) < len(str(self)):
            lines = lines.rpartition("\n")[0] + f"\n… (print shows all)\n{last}"
        text = f'<pre style="border-left: 4px solid {colour}; padding-left: 1em">{html.escape(lines)}</pre>'
        if self.holds:
            return text
        # Notebooks keep what is shown, so it has to be small.
        pictures = "".join(map(picture_of, self.to_dict()["violations"][:MOST_PICTURES]))
        return f"{text}\n{pictures}" if len(text) + len(pictures) <= LARGEST_SHOWN else text


def violation_of(entry: Dict[str, Any]) -> Violation:
    """From JSON."""
    ball = entry.get("ball")
    return Violation(
        entry["rule"], entry["meaning"], entry["simplices"], entry.get("face"), entry["vertices"],
        {name: Fraction(value["exact"]) for name, value in entry["values"].items()},
        ball and Ball(point_of(ball["centre"]), Fraction(ball["squared_radius"]["exact"])),
        point_of(entry["point"]) if "point" in entry else None)


class Comparison:
    """Are two meshes the same complex? If not, `only_in_a` and `only_in_b` have the points and simplices that
    differ."""

    def __init__(self, parts: tuple):
        self.same: bool
        self.same, text = parts
        document = json.loads(text)
        self.only_in_a: dict = document["only_in_a"]
        self.only_in_b: dict = document["only_in_b"]

    def __bool__(self) -> bool:
        return self.same

    def __repr__(self) -> str:
        sides = (f"{len(side['points'])} points and {len(side['simplices'])} simplices only in {name}"
                 for name, side in (("a", self.only_in_a), ("b", self.only_in_b)))
        return "<Comparison same>" if self.same else f"<Comparison {', '.join(sides)}>"
