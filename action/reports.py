#!/usr/bin/env python3
"""JUnit and SARIF from what `circumspect check --format json` printed:

    reports.py REPORT.json JUNIT.xml REPORT.sarif
"""
import json
import sys
import urllib.parse
import xml.etree.ElementTree as xml


def place(result):
    """The file that a result is about."""
    return result.get("mesh") or result.get("domain") or "-"


def sentences(result):
    """What is wrong, one line each: (rule, sentence), and after the rules what may be the cause. Empty if nothing is wrong."""
    if "error" in result:
        return [("input", result["error"])]
    if "undecided" in result:
        return [("undecided", result["undecided"])]
    found = []
    for violation in result.get("violations", []):
        cells = " and ".join(" ".join(map(str, one)) for one in violation["simplices"])
        where = (f"; simplex {cells}" if cells else "") + "".join(f"; vertex {v}" for v in violation["vertices"])
        found.append((violation["rule"], violation["meaning"] + where))
    counted = {rule for rule, _ in found}
    found += [(rule["rule"], f"{rule['count']} times") for rule in result.get("rules", [])
              if rule["rule"] not in counted]
    return found + [("cause." + cause["cause"], f"{cause['text']} (explains {cause['explains']} of {cause['of']})")
                    for cause in result.get("causes", [])]


def printable(text):
    """What XML can hold."""
    return "".join(c if c >= " " or c in "\t\n" else "\ufffd" for c in text)


def junit(results):
    """A test case for each mesh."""
    suite = xml.Element("testsuite", name="circumspect check", tests=str(len(results)),
                        failures=str(sum(result.get("verdict") == "fails" for result in results)),
                        errors=str(sum("verdict" not in result for result in results)))
    for result in results:
        case = xml.SubElement(suite, "testcase", name=printable(place(result)), classname="circumspect." + result.get("claim", "input"))
        wrong = sentences(result)
        if wrong:
            kind = "failure" if "verdict" in result else "error"
            text = printable("\n".join(f"{rule}: {sentence}" for rule, sentence in wrong))
            xml.SubElement(case, kind, type=wrong[0][0], message=text.split("\n", 1)[0]).text = text
    suites = xml.Element("testsuites")
    suites.append(suite)
    return xml.tostring(suites, encoding="unicode", xml_declaration=True)


def sarif(results):
    """A result for each witness."""
    found = [(place(result), rule, text) for result in results for rule, text in sentences(result)]
    rules = sorted({rule for _, rule, _ in found})
    return {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json", "version": "2.1.0",
        "runs": [{
            "tool": {"driver": {"name": "circumspect", "rules": [{"id": rule} for rule in rules]}},
            "results": [{"ruleId": rule, "level": "note" if rule.startswith("cause.") else "error", "message": {"text": text},
                         "locations": [{"physicalLocation": {"artifactLocation": {"uri": urllib.parse.quote(name)}}}]}
                        for name, rule, text in found]}]}


def main(report, junit_file, sarif_file):
    """Writes both. A run that was refused as a whole, as by a wrong option, printed nothing: then so do these."""
    with open(report, encoding="utf-8") as file:
        text = file.read()
    results = json.loads(text)["results"] if text.strip() else []
    with open(junit_file, "w", encoding="utf-8") as file:
        file.write(junit(results))
    with open(sarif_file, "w", encoding="utf-8") as file:
        json.dump(sarif(results), file, indent=2)


if __name__ == "__main__":
    main(*sys.argv[1:])
