"""Trainers take exact square roots, which every processor gives; MKL's own differ between the makes."""

import subprocess
import sys
from pathlib import Path

import pytest

from command_models import trainers

torch = pytest.importorskip("torch")
numpy = pytest.importorskip("numpy")

PROGRAM = """
import numpy, torch
numbers = torch.rand(10000, generator=torch.Generator().manual_seed(1)) * 3
print(int((numbers.sqrt().numpy() != numpy.sqrt(numbers.numpy())).sum()))
"""


def roots_that_differ(folder: Path, *command: str) -> int:
    (folder / "roots.py").write_text(PROGRAM)
    environment = trainers.environment()
    environment["PYTHONPATH"] += f":{folder}"
    ended = subprocess.run([sys.executable, "-m", *command], env=environment, stdout=subprocess.PIPE, check=True)
    return int(ended.stdout)


def test_roots_are_exact_in_a_trainer(tmp_path: Path) -> None:
    assert roots_that_differ(tmp_path, "command_models.reproducible", "roots") == 0


def test_roots_keep_their_type_and_gradient() -> None:
    from command_models.reproducible import exact_square_root

    numbers = torch.tensor([4.0, 2.0], requires_grad=True)
    roots = exact_square_root(numbers)
    roots.sum().backward()
    assert roots.dtype == torch.float32
    assert numbers.grad.tolist() == pytest.approx([0.25, 0.5 / 2**0.5])


def test_every_trainer_runs_so() -> None:
    data, models, effort = Path("data"), Path("models"), trainers.Effort()
    made = (
        trainers.tokenizer,
        trainers.mwt,
        trainers.lemmatizer,
        trainers.tagger,
        trainers.settled_tagger,
        trainers.parser,
        trainers.settled_parser,
        trainers.settled_longer,
    )
    for command in made:
        assert "command_models.reproducible" in command(data, models, effort, 1)
