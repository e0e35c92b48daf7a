"""The figures are written between the marks of the model card, and nowhere else."""

import json

import pytest

from command_models import card
from command_models.errors import TrainingError

MANIFEST = {"bytes": 7, "files": [{"path": "en/pos/command.pt", "bytes": 7, "md5": "abc"}]}


@pytest.fixture
def files(tmp_path):
    raw = dict.fromkeys(card.PUBLISHED, 50.0)
    (tmp_path / "figures.json").write_text(json.dumps({card.RAW: raw, "commands": {"LAS": 91.25}}), encoding="utf-8")
    (tmp_path / "manifest.json").write_text(json.dumps(MANIFEST), encoding="utf-8")
    text = f"# Card\n{card.BEGIN}\nstale\n{card.END}\nlast words\n"
    (tmp_path / "MODEL_CARD.md").write_text(text, encoding="utf-8")
    return tmp_path


def test_figures_replace_the_old_ones(files):
    made = files / "MODEL_CARD.md"
    card.update(made, files / "figures.json", files / "manifest.json")
    text = made.read_text(encoding="utf-8")
    assert text.startswith("# Card\n") and text.endswith("last words\n")
    assert "stale" not in text
    assert "| LAS | 50.00 | - | 86.77 |" in text
    assert "| LAS | 91.2 |" in text
    assert "| en/pos/command.pt | 7 | abc |" in text
    card.update(made, files / "figures.json", files / "manifest.json")
    assert made.read_text(encoding="utf-8") == text


def test_card_without_marks_is_refused(files):
    (files / "MODEL_CARD.md").write_text("# Card\n", encoding="utf-8")
    with pytest.raises(TrainingError) as error:
        card.update(files / "MODEL_CARD.md", files / "figures.json", files / "manifest.json")
    assert "marks" in str(error.value)


def test_missing_figures_are_named(files):
    with pytest.raises(TrainingError) as error:
        card.update(files / "MODEL_CARD.md", files / "nowhere.json", files / "manifest.json")
    assert "nowhere.json" in str(error.value)
