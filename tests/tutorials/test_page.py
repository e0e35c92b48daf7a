"""How a page becomes a script."""

import subprocess
from pathlib import Path

import pytest

from page import blocks, pattern_of, script_of, steps

PAGE = """
```yaml folder/file.yaml
a: $HOME
```
```bash
cat folder/file.yaml
export WORD=kept
```
```text
a: $HOME
```
```bash background
sleep 1; touch there; sleep 100
```
```bash
ls there
```
```bash status=3
echo $WORD
exit 3
```
```text
kept
```
```xml
<shown/>
```
"""


def run(text: str, folder: Path) -> "subprocess.CompletedProcess[str]":
    script = script_of(text, folder)
    return subprocess.run(["bash", "-c", script], cwd=folder, timeout=300, check=False, capture_output=True, text=True)


def test_page_is_run(tmp_path: Path) -> None:
    assert run(PAGE, tmp_path).returncode == 0
    assert (tmp_path / "reached").read_text() == "done\n"
    for number, step in enumerate(steps(PAGE)):
        assert step.output.fullmatch((tmp_path / f"{number}.out").read_text())


def test_wrong_status_ends_the_page(tmp_path: Path) -> None:
    assert run(PAGE.replace("exit 3", "exit 4"), tmp_path).returncode != 0
    assert (tmp_path / "reached").read_text() == "3\n"
    assert run(PAGE.replace("cat folder", "false; cat folder"), tmp_path).returncode != 0
    assert (tmp_path / "reached").read_text() == "0\n"


def test_blocks_have_their_lines() -> None:
    assert [(block.language, block.option, block.line) for block in blocks(PAGE)][:2] == [
        ("yaml", "folder/file.yaml", 2),
        ("bash", "", 5),
    ]


@pytest.mark.parametrize(
    "pattern, text, is_same",
    [
        ("a\n", "a\n", True),
        ("a\n", "a\nb\n", False),
        ("...\nb\n", "a\na\nb\n", True),
        ("b\n...\n", "b\n", True),
        ("a...c\n", "abc\n", True),
        ("a...c\n", "a\nc\n", False),
        ("(a)\n", "(a)  \n", True),
    ],
)
def test_patterns(pattern: str, text: str, is_same: bool) -> None:
    assert bool(pattern_of(pattern).fullmatch(text)) == is_same
