"""The scores on the corpora do not fall below those reached before."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Dict, List

import pytest

from roboframenet_testing.workspace import package

RFN = package("roboframenet_tools") / "nodes" / "rfn"
FIVE_FOLDS = ["--folds", "5"]


@pytest.mark.acceptance
@pytest.mark.parametrize(
    "corpus,folder,options,reached",
    [
        ("huric", "huric-dev", [], {"fp": 97.3, "aic_exact": 94.2}),
        ("huric", "huric-dev", FIVE_FOLDS, {"fp": 94.8, "aic_exact": 90.2}),
        ("tage", "tage-dev", [], {"fp": 91.6, "aic_exact": 66.3}),
    ],
)
def test_scores_do_not_fall(
    corpora: Path, corpus: str, folder: str, options: List[str], reached: Dict[str, float]
) -> None:
    if not (corpora / folder).is_dir():
        pytest.skip(f"there is no folder {folder} among the corpora")
    run = subprocess.run(
        [sys.executable, str(RFN), "score", corpus, str(corpora / folder), "--json", *options],
        stdout=subprocess.PIPE,
        timeout=1800,
        check=True,
    )
    found = json.loads(run.stdout)
    print({name: found[name] for name in (*reached, "coverage", "precision_answered")})
    assert {name: round(found[name], 1) for name in reached if round(found[name], 1) < reached[name]} == {}
