"""JUnit's XML of one student, for what runs tests by itself: wrong answers are failures; crashes and what the machine
could not do are errors. It has no times: the same results give the same bytes.
"""

from xml.etree import ElementTree as xml

from app.grade.report.stored import Sheet
from app.grade.report.words import ILLEGAL, NO_VALUES, point, region, sentence, verdict


def legal(text: str) -> str:
    return ILLEGAL.sub("", text)


def junit(sheet: Sheet) -> bytes:
    result = sheet.result
    cases = [case(test) for test in result["tests"]] or [whole(result)]
    counts = {"tests": len(cases)} | {
        name: sum(case.find(tag) is not None for case in cases)
        for name, tag in (("failures", "failure"), ("errors", "error"), ("skipped", "skipped"))}
    numbers_of = {name: str(count) for name, count in counts.items()}
    root = xml.Element("testsuites", numbers_of)
    name = legal(f"{sheet.assignment['id']}: {sheet.student}")
    suite = xml.SubElement(root, "testsuite", {"name": name} | numbers_of)
    known = xml.SubElement(suite, "properties")
    facts = {"score": "" if sheet.mark is None else f"{sheet.mark:.6g}", "max": f"{sheet.most:.6g}",
             "verdict": result["verdict"], "submission": result["submission"]["hash"],
             "assignment": sheet.assignment["hash"], "level": result["grader"]["level"],
             "fingerprint": result["grader"]["fingerprint"], "unsandboxed": str(result["grader"]["unsandboxed"])}
    for key, value in facts.items():
        xml.SubElement(known, "property", {"name": key, "value": legal(value)})
    suite.extend(cases)
    xml.indent(root, " ")
    return xml.tostring(root, "utf-8", xml_declaration=True) + b"\n"


def case(test: dict) -> xml.Element:
    found = xml.Element("testcase", {"name": legal(region(test)), "classname": legal(test["function"])})
    word = test["verdict"]
    if word != "pass":
        tag = "skipped" if word == "skipped" else "error" if word in NO_VALUES - {"missing"} else "failure"
        message = {"message": legal(sentence(test))} | ({} if tag == "skipped" else {"type": word})
        told = xml.SubElement(found, tag, message)
        if test["worst"]:
            told.text = legal(point(test["worst"]))
    return found


def whole(result: dict) -> xml.Element:
    """In the place of all tests, where none was run."""
    found = xml.Element("testcase", {"name": "the submission", "classname": "submission"})
    word = result["verdict"]
    xml.SubElement(found, "error", {"message": legal(f"{verdict(word)}. {result.get('why', '')}"), "type": word})
    return found
