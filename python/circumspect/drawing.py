"""A small picture of a witness for notebooks: SVG, without scripts. `Verdict.to_html` has those that can be turned."""
from __future__ import annotations

import fractions
import html
import itertools
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

SIZE, MARGIN = 260.0, 24.0
MOST_SIMPLICES = 40
MOST_STRETCHED = 1000  # a picture whose sides differ by more is stretched
COLOURS = ("#0969da", "#bf8700", "#8250df")  # of simplices, one after the other
Exact = Tuple[fractions.Fraction, ...]
Place = Tuple[float, float]


def picture_of(violation: Dict[str, Any]) -> str:
    """Of an entry of the JSON report; empty if it names no points of the plane or of space."""
    known = {int(vertex): tuple(map(fractions.Fraction, texts))
             for vertex, texts in violation.get("coordinates", {}).items()}
    own = [tuple(map(fractions.Fraction, violation[key])) for key in ("point",) if key in violation]
    rows = [*known.values(), *own]
    if not rows or any(len(row) not in (2, 3) or len(row) != len(rows[0]) for row in rows):
        return ""
    place, scale = placed(rows, len(rows[0]))
    shapes: List[str] = []
    for i, simplex in enumerate(violation["simplices"][:MOST_SIMPLICES]):
        shapes += simplex_of([known[v] for v in simplex if v in known], place, COLOURS[i % len(COLOURS)])
    face = [place(known[v]) for v in violation.get("face") or () if v in known]
    shapes += [line(a, b, "#cf222e", 3) for a, b in itertools.combinations(face, 2)]
    ball = violation.get("ball")
    if ball and scale and len(rows[0]) == 2:
        centre = place(tuple(map(fractions.Fraction, ball["centre"])))
        radius = float(ball["radius_decimal"]) * scale
        if max(radius, *map(abs, centre)) < 50 * SIZE:
            shapes.append(f'<circle cx="{centre[0]:.2f}" cy="{centre[1]:.2f}" r="{radius:.2f}" fill="none" stroke="#1a7f37"/>')
    named = set(violation["vertices"])
    for vertex, row in known.items():
        shapes += dot(place(row), str(vertex), "#cf222e" if vertex in named else "#24292f")
    shapes += [part for row in own for part in dot(place(row), "", "#1a7f37")]
    caption = html.escape(f"{violation['rule']}: {violation['meaning']}")
    return (f'<figure style="display: inline-block; margin: 0 1em 0 0; max-width: {SIZE:.0f}px">'
            f'<svg width="{SIZE:.0f}" height="{SIZE:.0f}" role="img" style="background: #fff">'
            f'{"".join(shapes)}</svg><figcaption><small>{caption}</small></figcaption></figure>')


def placed(rows: Sequence[Exact], dimension: int) -> Tuple[Callable[[Exact], Place], Optional[float]]:
    """Where a point is in the picture; and how long 1 is, unless the picture is stretched. Space is seen from the
    front, the right and above."""
    low = [min(axis) for axis in zip(*rows)]
    sides = [max(axis) - least for axis, least in zip(zip(*rows), low)]
    longest = max(sides) or fractions.Fraction(1)
    is_stretched = any(side and longest > MOST_STRETCHED * side for side in sides)
    units = [(side or longest) if is_stretched else longest for side in sides]

    def place(row: Exact) -> Place:
        # The differences are exact, so that near points stay apart.
        at = [float((x - least) / unit) for x, least, unit in zip(row, low, units)]
        if dimension == 3:
            at = [0.62 * at[0] + 0.38 * at[1], 0.72 * at[2] + 0.28 * at[1] - 0.16 * at[0] + 0.16]
        reach = SIZE - 2 * MARGIN
        return MARGIN + reach * at[0], SIZE - MARGIN - reach * at[1]

    return place, None if is_stretched else (SIZE - 2 * MARGIN) / float(longest)


def simplex_of(corners: Sequence[Exact], place: Callable[[Exact], Place], colour: str) -> List[str]:
    """A triangle is filled; of others the edges are drawn."""
    at = [place(corner) for corner in corners]
    shapes = []
    if len(at) == 3:
        points = " ".join(f"{x:.2f},{y:.2f}" for x, y in at)
        shapes.append(f'<polygon points="{points}" fill="{colour}" fill-opacity="0.2"/>')
    return shapes + [line(a, b, colour, 1.5) for a, b in itertools.combinations(at, 2)]


def line(a: Place, b: Place, colour: str, width: float) -> str:
    """From one place to another."""
    return (f'<line x1="{a[0]:.2f}" y1="{a[1]:.2f}" x2="{b[0]:.2f}" y2="{b[1]:.2f}" stroke="{colour}" '
            f'stroke-width="{width}"/>')


def dot(at: Place, label: str, colour: str) -> List[str]:
    """A vertex and its index."""
    text = f'<text x="{at[0] + 5:.2f}" y="{at[1] - 5:.2f}" font-size="12" fill="{colour}">{html.escape(label)}</text>'
    return [f'<circle cx="{at[0]:.2f}" cy="{at[1]:.2f}" r="3.5" fill="{colour}"/>', *([text] if label else [])]
