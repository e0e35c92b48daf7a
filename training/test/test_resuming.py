"""An interrupted build goes on where it was, and from nothing that other settings left."""

import json
from dataclasses import replace

import pytest

from command_models import building, card, steps, trainers
from command_models.errors import TrainingError


@pytest.fixture
def step(tmp_path):
    (tmp_path / "data").write_text("data", encoding="utf-8")
    ran = []

    def run():
        ran.append((tmp_path / "half").is_file())
        (tmp_path / "half").write_text("half", encoding="utf-8")
        if len(ran) == 1:
            raise TrainingError("interrupted")
        (tmp_path / "model").write_text("model", encoding="utf-8")

    made = steps.Step(
        "train", (tmp_path / "data",), (tmp_path / "model",), {"rate": 1}, run, tmp_path / "log", (tmp_path / "half",)
    )
    return made, ran


def test_interrupted_training_goes_on(step, tmp_path):
    made, ran = step
    with pytest.raises(TrainingError, match="interrupted"):
        steps.execute([made], tmp_path / "records", 1)
    steps.execute([made], tmp_path / "records", 1)
    assert ran == [False, True]
    steps.execute([made], tmp_path / "records", 1)
    assert len(ran) == 2


def test_training_with_other_settings_starts_anew(step, tmp_path):
    made, ran = step
    with pytest.raises(TrainingError, match="interrupted"):
        steps.execute([made], tmp_path / "records", 1)
    steps.execute([replace(made, settings={"rate": 2})], tmp_path / "records", 1)
    assert ran == [False, False]


def test_shipped_models_need_no_option(tmp_path):
    for part in ("train", "dev", "test"):
        (tmp_path / f"en_ewt-{part}.conllu").write_text("", encoding="utf-8")
    plan = building.Plan(tmp_path, tmp_path / "childes", tmp_path, tmp_path / "work", tmp_path / "out")
    made = {one.name: one for one in building.steps(plan)}
    outputs = {path.name for one in made.values() for path in one.outputs}
    assert {"vectors.pt", "tokenizer.pt", "mwt.pt", "tagger.pt", "lemma.pt", "parser.pt"} <= outputs
    assert "parser-settled.pt" in {path.name for path in made["settle-longer"].inputs}
    assert "elaborate.conllu" in {path.name for path in made["settle-longer"].inputs}
    assert vars(plan.effort) == vars(trainers.Effort())


def test_trainers_do_not_choose_their_arithmetic_by_the_processor(monkeypatch):
    monkeypatch.setenv("MKL_CBWR", "AVX512")
    assert trainers.ARITHMETIC.items() <= trainers.environment().items()


def test_figures_are_compared_with_those_of_a_card(tmp_path):
    figures = {card.RAW: dict.fromkeys(card.PUBLISHED, 90.0), "commands, percent": {"LAS": 80.0}, "times": {"p50": 3.0}}
    (tmp_path / "figures.json").write_text(json.dumps(figures), encoding="utf-8")
    (tmp_path / "manifest.json").write_text("{}", encoding="utf-8")
    (tmp_path / "card.md").write_text(f"{card.BEGIN}\n{card.END}\n", encoding="utf-8")
    card.update(tmp_path / "card.md", tmp_path / "figures.json", tmp_path / "manifest.json")
    assert card.differences(tmp_path / "card.md", tmp_path / "figures.json", 0.2) == []
    figures[card.RAW]["LAS"] = 89.7
    figures["commands, percent"]["LAS"] = 80.5
    figures["times"]["p50"] = 30.0
    (tmp_path / "figures.json").write_text(json.dumps(figures), encoding="utf-8")
    assert len(card.differences(tmp_path / "card.md", tmp_path / "figures.json", 0.2)) == 2
    (tmp_path / "figures.json").write_text("{}", encoding="utf-8")
    with pytest.raises(TrainingError, match="no figure"):
        card.differences(tmp_path / "card.md", tmp_path / "figures.json", 0.2)
