#!/usr/bin/python3
"""Hunts a library that takes segments beside points: its mesh has to be the constrained Delaunay triangulation of the hull.

    PYTHONPATH=build/release/python fuzz/hunt/hunt_segments.py cdt2d-segments --builds DIR --output DIR [--time 60]

The domains are those of the families of the plane, without holes and without segments that are listed twice; every other one is turned by
some angle, so that its points are rounded, and taken if its segments still do not cross. The options and what is written are as those of hunt.py.
"""
import json
import sys
import time
from pathlib import Path

import numpy as np

from circumspect import Domain, _core
from circumspect.campaigns import domain_case, is_wanted
from circumspect.meshes import mesh_of, points_of
from hunt import Adapter, Refused, arguments_and_row, command_of

FAMILIES = ["planar-segments", "planar-grid"]


def plain(domain):
    """The hull with the segments, each once."""
    segments = sorted({tuple(sorted(pair)) for pair in np.asarray(domain.segments).reshape(-1, 2).tolist() if pair[0] != pair[1]})
    return Domain(domain.points, segments, kind="hull")


def turned(domain, angle):
    """Rounded to doubles."""
    points = np.asarray(domain.points)
    matrix = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return Domain(points @ matrix.T, domain.segments, kind="hull")


def is_complex(domain):
    """Whether its segments meet in common corners alone, and no two points are one."""
    try:
        _core.check("plc-triangulation", points_of(domain.points).parts(), domain.parts(), 1, 1, False, False, None, "", True)
    except _core.InputError:
        return False
    return True


class Judge:
    """What comes of a domain, as the name of a rule or of how the adapter ended, with a report; empty if all is well."""

    def __init__(self, adapter):
        self.adapter = adapter

    def outcome(self, domain):
        try:
            made = self.adapter(np.asarray(domain.points), np.asarray(domain.segments).reshape(-1, 2).tolist())
        except Refused:
            return "", "", None
        except RuntimeError as error:
            return "raised", str(error), None
        except TimeoutError as error:
            return "hang", str(error), None
        except (ConnectionError, ValueError) as error:
            self.adapter.close()
            return "crash", str(error), None
        verdict = _core.check("cdt", mesh_of(domain.points, made).parts(), domain.parts(), 1, 3, False, False, None, "mesh", True)
        # verdict: whether it holds, counts, the text for people, and the rules that are broken
        report = next(part for part in verdict if isinstance(part, str) and ("holds" in part or "fails" in part))
        rules = next(part for part in verdict if isinstance(part, dict))
        return ("" if verdict[0] else next(iter(rules))), report, made.tolist()


def is_plain(domain):
    return len(domain.points) > 2 and is_wanted(np.asarray(domain.points), False)


def hunt(row, arguments):
    judge = Judge(Adapter(command_of(row, arguments), arguments.limit))
    counts, first, cases, start, index = {}, {}, 0, time.monotonic(), 0
    while time.monotonic() - start < arguments.time:
        index += 1
        _, _, lists = _core.drawn_domain_case(FAMILIES, 2, arguments.points if index % 20 else 60, arguments.seed, index)
        domain = plain(domain_case(lists).domain)
        if index % 2:
            domain = turned(domain, index)
        if not is_plain(domain) or not is_complex(domain):
            continue
        cases += 1
        rule, _, _ = judge.outcome(domain)
        if rule:
            counts[rule] = counts.get(rule, 0) + 1
            if rule not in first or len(domain.points) < len(first[rule].points):
                first[rule] = domain
    folder = Path(arguments.output) / row["target"]
    folder.mkdir(parents=True, exist_ok=True)
    found = {}
    for rule, domain in first.items():
        def still_fails(lists):
            smaller = plain(Domain.of_lists(lists))
            return is_plain(smaller) and is_complex(smaller) and judge.outcome(smaller)[0] == rule

        small = plain(Domain.of_lists(_core.minimized_domain(domain.lists(), still_fails, 20000, 8 * arguments.small_time)))
        repeats = 0
        for _ in range(3):
            judge.adapter.close()
            again, report, simplices = judge.outcome(small)
            repeats += again == rule
        found[rule] = [len(small.points), len(small.segments), repeats]
        (folder / f"{rule}.json").write_text(json.dumps(dict(
            rule=rule, kind="domain", repeats=repeats, points=np.asarray(small.points).tolist(),
            segments=np.asarray(small.segments).reshape(-1, 2).tolist(), report=report, simplices=simplices), indent=1))
    judge.adapter.close()
    summary = dict(target=row["target"], library=row["library"], version=row["version"], cases=cases, seconds=round(arguments.time),
                   hold=cases - sum(counts.values()), counts=counts, found=found)
    (folder / "summary.json").write_text(json.dumps(summary, indent=1))
    return summary


if __name__ == "__main__":
    given, target = arguments_and_row(sys.argv[1:])
    print(json.dumps(hunt(target, given)))
