"""Packing writes the right layout and refuses wrong models; a resumed build repeats no step."""

import json
from pathlib import Path

import pytest

from command_models import packing, steps
from command_models.errors import TrainingError

torch = pytest.importorskip("torch", reason="packing handles torch checkpoints")
NAMES = ("vectors.pt", "tokenizer.pt", "mwt.pt", "tagger.pt", "lemma.pt", "parser.pt")


@pytest.fixture
def trained(tmp_path):
    folder = tmp_path / "models"
    folder.mkdir()
    for name in NAMES:
        torch.save({"model": {"weight": torch.ones(4, 4)}, "config": {"size": 4}, "vocab": ["a"]}, str(folder / name))
    return folder


def test_layout_and_index(trained, tmp_path):
    out = tmp_path / "out"
    packed = packing.pack(trained, out, {"stanza": "1.15.0"})
    assert len(packed) == 6
    index = json.loads((out / "resources.json").read_text(encoding="utf-8"))["en"]
    assert index["packages"]["default"] == dict.fromkeys(
        ("tokenize", "mwt", "pos", "lemma", "depparse"), packing.PACKAGE
    )
    for entry in packed:
        assert (out / entry.path).stat().st_size == entry.size
        assert steps.digest(out / entry.path) == entry.md5
        assert index[entry.path.split("/")[1]][packing.PACKAGE]["md5"] == entry.md5
    for processor in ("pos", "depparse"):
        assert index[processor][packing.PACKAGE]["dependencies"] == [{"model": "pretrain", "package": packing.PACKAGE}]
    manifest = json.loads((out / "manifest.json").read_text(encoding="utf-8"))
    assert manifest["versions"] == {"stanza": "1.15.0"}
    assert manifest["bytes"] == sum(entry.size for entry in packed)


def test_weights_are_halved_but_not_the_vectors(trained, tmp_path):
    out = tmp_path / "out"
    packing.pack(trained, out, {})
    small = torch.load(str(out / "en/pos/command.pt"), weights_only=True)
    vectors = torch.load(str(out / "en/pretrain/command.pt"), weights_only=True)
    assert small["model"]["weight"].dtype == torch.float16
    assert vectors["model"]["weight"].dtype == torch.float32


def test_no_folder_of_the_training_is_packed(trained, tmp_path):
    for name in NAMES[1:]:
        checkpoint = torch.load(str(trained / name), weights_only=True)
        checkpoint["config"].update(
            train_file=f"{trained}/a.conllu;{trained}/b.conllu", save_dir=str(trained), shorthand="en_x", charlm=None
        )
        torch.save(checkpoint, str(trained / name))
    packed = packing.pack(trained, tmp_path / "out", {})
    for entry in packed:
        assert str(tmp_path).encode() not in (tmp_path / "out" / entry.path).read_bytes()
    config = torch.load(str(tmp_path / "out/en/pos/command.pt"), weights_only=True)["config"]
    assert config == {
        "size": 4,
        "train_file": "a.conllu;b.conllu",
        "save_dir": "models",
        "shorthand": "en_x",
        "charlm": None,
    }


def test_halving_keeps_all_else():
    given = {"a": [torch.ones(1), 3, "x"], "b": (torch.ones(1, dtype=torch.int64), None)}
    made = packing.halved(given)
    assert made["a"][0].dtype == torch.float16
    assert made["a"][1:] == [3, "x"]
    assert made["b"][0].dtype == torch.int64 and made["b"][1] is None


def test_missing_model_is_named(trained, tmp_path):
    (trained / "parser.pt").unlink()
    with pytest.raises(TrainingError) as error:
        packing.pack(trained, tmp_path / "out", {})
    assert "parser.pt" in str(error.value)


def test_too_large_is_refused(trained, tmp_path, monkeypatch):
    monkeypatch.setattr(packing, "LIMIT", 100)
    with pytest.raises(TrainingError) as error:
        packing.pack(trained, tmp_path / "out", {})
    assert "limit" in str(error.value)


def make_step(folder: Path, name: str, inputs, calls, setting: int = 1) -> steps.Step:
    output = folder / (name + ".out")

    def run() -> None:
        calls.append(name)
        output.write_text(name + "".join(path.read_text(encoding="utf-8") for path in inputs), encoding="utf-8")

    return steps.Step(name, tuple(inputs), (output,), {"setting": setting}, run, folder / (name + ".log"))


def test_steps_run_in_order_and_once(tmp_path):
    calls = []
    source = tmp_path / "source"
    source.write_text("1", encoding="utf-8")
    first = make_step(tmp_path, "first", [source], calls)
    second = make_step(tmp_path, "second", [first.outputs[0]], calls)
    records = tmp_path / "records"
    steps.execute([second, first], records, 2)
    assert calls == ["first", "second"]
    steps.execute([second, first], records, 2)
    assert calls == ["first", "second"]
    source.write_text("2", encoding="utf-8")
    steps.execute([second, first], records, 1)
    assert calls == ["first", "second", "first", "second"]


def test_changed_setting_runs_again(tmp_path):
    calls = []
    records = tmp_path / "records"
    steps.execute([make_step(tmp_path, "only", [], calls)], records, 1)
    steps.execute([make_step(tmp_path, "only", [], calls, setting=2)], records, 1)
    assert calls == ["only", "only"]


def test_failure_names_the_step_and_keeps_the_others(tmp_path):
    calls = []
    good = make_step(tmp_path, "good", [], calls)

    def fail() -> None:
        raise TrainingError("no space left")

    bad = steps.Step("bad", good.outputs, (tmp_path / "bad.out",), {}, fail, tmp_path / "bad.log")
    with pytest.raises(TrainingError) as error:
        steps.execute([good, bad], tmp_path / "records", 1)
    assert "step bad failed" in str(error.value) and "no space left" in str(error.value)
    assert steps.done(good, tmp_path / "records")


def test_missing_input_is_named(tmp_path):
    step = make_step(tmp_path, "lonely", [tmp_path / "nowhere"], [])
    with pytest.raises(TrainingError) as error:
        steps.execute([step], tmp_path / "records", 1)
    assert "nowhere" in str(error.value)
