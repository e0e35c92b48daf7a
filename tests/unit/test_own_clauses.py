"""What is asked and said about the robot itself is read by the grammar of its units, in wordings that no unit lists.

``own_clauses.tsv`` has a sentence and its frame in each line, "-" for a sentence that none of these frames may read.
"""

from pathlib import Path

import pytest

from offline_pipeline.pipeline import Pipeline

ROWS = [
    row.split("\t")
    for row in (Path(__file__).resolve().parent / "own_clauses.tsv").read_text(encoding="utf-8").splitlines()
]
FRAMES = frozenset(frame for _, frame in ROWS)


@pytest.mark.parametrize("text, frame", ROWS)
def test_a_clause_about_the_robot_has_its_frame(pipeline: Pipeline, text: str, frame: str) -> None:
    found = [reading.unit.frame_name for reading in pipeline.understand(text).readings]
    if frame == "-":
        assert not FRAMES.intersection(found), found
    else:
        assert found == [frame]
