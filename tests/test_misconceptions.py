"""Every row of the table of misconceptions: its variant fails, and triggers this row and no other."""

from dataclasses import replace

import numpy as np
import pytest

from app.grade.agree import truth
from app.grade.assignment import assignments, load
from app.grade.judge import judge
from app.grade.misconceptions import MESSAGES, factor, known, suspects
from app.grade.question import Reply
from app.grade.questions import questions
from app.grade.variants import VARIANTS
from app.paths import ROOT

LOADED = [*(load(name) for name in assignments()), load(ROOT / "tests" / "misconceptions.toml")]
TASKS = {task.function: (one, task) for one in reversed(LOADED) for task in one.tasks}
ROWS = [(name, function, i) for function in TASKS for name, (_, variants) in known(TASKS[function][1]).items()
        for i in range(len(variants))]


@pytest.mark.parametrize(("name", "function", "which"), ROWS, ids=str)
@pytest.mark.parametrize("language", ["python", "glsl"])
def test_a_variant_triggers_its_row_and_no_other(name, function, which, language):
    if name == "unstable_form" and language == "python":
        return  # the digits are lost in float32
    assignment, task = TASKS[function]
    one = replace(assignment, tasks=(replace(task, picture=None, runtime=0.0),))
    asked = questions(one, languages=(language,)) + questions(one, "secret", True, (language,))
    kind = np.float32 if name == "unstable_form" else float
    variant = known(task)[name][1][which]
    with np.errstate(all="ignore"):
        replies = [Reply(q.id, np.asarray(variant(**{key: x.astype(kind) for key, x in q.args.items()}), float))
                   for q in asked]
    result = judge(one, asked, replies)
    assert result.verdict != "pass" and result.score < result.max
    assert [suspect.id for suspect in result.suspects] == [name]
    assert result.suspects[0].message and result.suspects[0].match >= 0.95


def test_the_table_is_whole():
    assert set(VARIANTS) == set(MESSAGES) and len(MESSAGES) == 45
    spoken = {name for name, _, _ in ROWS}
    assert set(MESSAGES) - spoken == set(), "a row that no function has"
    assert {function for row in VARIANTS.values() for function in row} <= set(TASKS)


def test_a_lecturers_own_mistake_is_told():
    task = TASKS["lobe_power"][1]
    assert known(task)["abs_for_max"][0].startswith("A cosine below 0")


def test_a_constant_looks_like_nothing():
    """0 is what a spotlight of the wrong sign gives nearly everywhere; who returns 0 has not begun."""
    assignment, task = TASKS["spot_linear"]
    args = questions(assignment, languages=("python",))[0].args
    assert suspects(task, "python", args, np.zeros(len(args["off_axis"]))) == []


def test_half_a_match_is_none():
    assignment, task = TASKS["f_schlick"]
    args = questions(assignment, languages=("python",))[0].args
    values = truth(task, args, "python").value.copy()
    wrong = args["f0"] + (1 - args["l_dot_h"]) ** 5
    assert [one.id for one in suspects(task, "python", args, wrong)] == ["schlick_no_complement"]
    values[::2] = wrong[::2]
    assert suspects(task, "python", args, values) == []


@pytest.mark.parametrize(("by", "words"), [(np.pi, ", all by the factor π"), (0.25, ", all by the factor 1/4"),
                                           (1.75, ", all by the factor 1.75"), (1.0, "")])
def test_a_constant_factor_is_told(by, words):
    right = np.linspace(0.5, 2, 40)
    assert factor(right, right * by) == words
    assert factor(right, right + by * np.sin(40 * right)) == ""
