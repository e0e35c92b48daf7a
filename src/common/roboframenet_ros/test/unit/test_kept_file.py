"""Values that outlive their process."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from roboframenet_ros.kept_file import KeptFile, remove_forgotten

WRITES_FOR_EVER = """
import sys
from pathlib import Path
from roboframenet_ros.kept_file import KeptFile
kept = KeptFile(Path(sys.argv[1]))
number = 0
while True:
    kept.save([number] * 5000)
    print(number, flush=True)
    number += 1
"""


def test_the_last_value_counts(tmp_path: Path) -> None:
    kept = KeptFile(tmp_path / "missing folder" / "value.json")
    assert kept.load() is None
    for value in ([{"text": "say \x07 it", "stamp_ns": 1_700_000_000_000_000_000}], [1], []):
        kept.save(value)
        assert KeptFile(tmp_path / "missing folder" / "value.json").load() == value
    kept.remove()
    kept.remove()
    assert kept.load() is None


def test_only_its_owner_reads_it(tmp_path: Path) -> None:
    path = tmp_path / "folder" / "value.json"
    KeptFile(path).save([1])
    assert path.stat().st_mode & 0o777 == 0o600
    assert path.parent.stat().st_mode & 0o777 == 0o700


def test_broken_file_and_folder_that_cannot_be_written_are_errors(tmp_path: Path) -> None:
    (tmp_path / "value.json").write_text("{\n")
    with pytest.raises(ValueError, match="Expecting"):
        KeptFile(tmp_path / "value.json").load()
    with pytest.raises(OSError, match="value"):
        KeptFile(tmp_path / "value.json" / "value.json").save([1])


def test_writer_that_is_killed_leaves_a_whole_value_no_older_than_the_last_that_it_saved(tmp_path: Path) -> None:
    path = tmp_path / "value.json"
    for after in range(1, 11):
        with subprocess.Popen(
            [sys.executable, "-c", WRITES_FOR_EVER, str(path)], stdout=subprocess.PIPE, text=True
        ) as writer:
            assert writer.stdout is not None
            for _ in range(7 * after):
                acknowledged = int(writer.stdout.readline())
            writer.send_signal(signal.SIGKILL)
            acknowledged = int((writer.stdout.read().split() or [acknowledged])[-1])
        value = KeptFile(path).load()
        assert isinstance(value, list)
        assert len(value) == 5000
        assert set(value) <= {acknowledged, acknowledged + 1}


def test_line_without_an_end_does_not_count(tmp_path: Path) -> None:
    kept = KeptFile(tmp_path / "value.json")
    (tmp_path / "value.json").write_text("[1]\n[2]\n[3")
    assert kept.load() == [2]
    (tmp_path / "value.json").write_text("[3")
    assert kept.load() is None


def test_file_does_not_grow_without_end(tmp_path: Path) -> None:
    kept = KeptFile(tmp_path / "value.json")
    sizes = []
    for number in range(3000):
        kept.save([number] * 100)
        sizes.append((tmp_path / "value.json").stat().st_size)
    assert max(sizes) < 1 << 19
    assert kept.load() == [2999] * 100


def test_files_of_masters_that_are_long_gone_are_removed(tmp_path: Path) -> None:
    for name, age_days in (("old", 31), ("young", 29)):
        KeptFile(tmp_path / f"{name}.json").save([1])
        os.utime(tmp_path / f"{name}.json", (0.0, 4e9 - 24 * 3600.0 * age_days))
    remove_forgotten(tmp_path, now_s=4e9)
    remove_forgotten(tmp_path / "missing", now_s=4e9)
    assert [path.name for path in tmp_path.iterdir()] == ["young.json"]
