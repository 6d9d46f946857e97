"""The stored mpmath values hold, and a wrong one is noticed."""

import json
from pathlib import Path

import pytest

from app.problem import Usage
from tests.reference.__main__ import main

GOLDEN = Path(__file__).parent / "reference" / "golden.json"


def altered(tmp_path: Path, name: str, **changes) -> str:
    """A file with the first record of that name changed."""
    data = json.loads(GOLDEN.read_text(encoding="utf-8"))
    record = next(r for r in data["values"] if r["name"] == name)
    record |= changes
    path = tmp_path / "golden.json"
    path.write_text(json.dumps({"meta": {}, "values": [record]}), encoding="utf-8")
    return str(path)


def test_stored_values_hold(capsys):
    assert main([str(GOLDEN)]) == 0
    said = capsys.readouterr().out
    assert "solid_angle.triangle.tiny_2^-20" in said
    assert "not mapped yet" not in said, "every stored name has its twin"


def test_a_wrong_value_is_noticed(tmp_path, capsys):
    assert main([altered(tmp_path, "solid_angle.cone", value="3.1415926535897e-24")]) == 1
    assert "solid_angle.cone" in capsys.readouterr().out


@pytest.mark.parametrize("changes", [{"value": "three"}, {"inputs": {"theta": "wide"}}, {"inputs": {"angle": "1"}},
                                     {"inputs": {}}, {"inputs": 3}, {"cond": "large"}, {"value": "inf"}])
def test_a_garbled_record_is_named(tmp_path, changes):
    with pytest.raises(Usage, match=r"solid_angle\.cone"):
        main([altered(tmp_path, "solid_angle.cone", **changes)])


@pytest.mark.parametrize("text", ["", "[]", "{", '{"values": 3}', '{"values": [3]}', '{"values": [{"name": "a.b"}]}'])
def test_a_garbled_file_is_refused(tmp_path, text):
    path = tmp_path / "golden.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Usage) as caught:
        main([str(path)])
    assert caught.value.code == 2
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)
    assert "Error" not in str(caught.value), "in words, not in Python's"


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(Usage, match="cannot be read"):
        main([str(tmp_path / "none.json")])
