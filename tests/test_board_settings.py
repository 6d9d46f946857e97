"""Parameters of the board's models as they are written on the command line."""

import json

import pytest

from app.__main__ import main
from app.board.board_step import id_of, started
from app.board.brdf_file import Parameter
from app.board.models import opened
from app.board.settings import checked, of_model, read
from app.problem import Usage
from app.state import parse

ROUGH = Parameter("rough", "float", 0.0, 1.0, 0.5, 4)
TINT = Parameter("tint", "color", 0.0, 1.0, (1.0, 0.5, 0.25), 5)
TWICE = Parameter("twice", "bool", 0.0, 1.0, False, 6)


def test_each_kind_is_read():
    assert read("0.25", ROUGH, "") == 0.25
    assert read("0.1,0.2,0.3", TINT, "") == (0.1, 0.2, 0.3) == read("0.1 0.2 0.3", TINT, "")
    assert read("yes", TWICE, "") is True and read("0", TWICE, "") is False


@pytest.mark.parametrize(("text", "parameter", "said"), [
    ("2", ROUGH, "goes from 0 to 1"), ("nan", ROUGH, "takes a number"), ("a", ROUGH, "takes a number"),
    ("1,2", TINT, "three numbers"), ("-1,0,0", TINT, "not below 0"), ("perhaps", TWICE, "yes or no"),
])
def test_what_is_no_value_is_told(text, parameter, said):
    with pytest.raises(Usage, match=said):
        read(text, parameter, f"{parameter.name}={text}")


def test_every_model_that_has_it_gets_it():
    models = [opened("cook_torrance"), opened("lambert")]
    checked(models, ["m=0.1", "rho=0.3"])
    assert of_model(models[0], ["m=0.1", "rho=0.3"]) == {"m": 0.1, "f0": 0.04}
    assert of_model(models[1], ["m=0.1", "rho=0.3"]) == {"rho": 0.3}
    with pytest.raises(Usage, match="no model here has a parameter rgo"):
        checked(models, ["rgo=0.3"])
    with pytest.raises(Usage, match="has no value"):
        checked(models, ["rho"])


def test_the_verdict_is_that_of_the_parameters(capsys):
    assert main(["board", "lambert", "--set", "rho=0.25", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["badges"]["energy"]["worst"] == pytest.approx(0.25, rel=1e-3)
    assert main(["board", "lambert", "--set", "rho=7", "--json"]) == 2


def test_the_window_starts_with_them():
    state = parse(started(id_of(["cook_torrance", "ggx", "geometry"]), ["f0=0.5", "alpha=0.2", "geometry=2"]))
    assert state.values["model0_f0"] == state.values["model1_f0"] == state.values["model2_f0"] == 0.5
    assert state.values["model1_alpha"] == 0.2 and state.values["model2_geometry"] == 2
    assert state.values["model0_m"] == 0.3
