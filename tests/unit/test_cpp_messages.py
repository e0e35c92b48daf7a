"""The messages have C++ headers that compile: a program in C++ can be a client of the action ``command``."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

REPOSITORY = Path(os.path.realpath(__file__)).parents[2]
INCLUDE = REPOSITORY / "devel" / "include"
PACKAGES = ("roboframenet_msgs", "stanford_parser_msgs")
#: A message of 2012 has a field "default", which is a keyword of C++; and its sum must not change.
NOT_FOR_CPP = ("EmptyFrameElement.h", "EmptySemanticFrame.h", "GetEmptyFrame.h", "GetEmptyFrameResponse.h")


@pytest.mark.parametrize("package", PACKAGES)
def test_headers_compile(package: str) -> None:
    messages = [path.stem for path in (REPOSITORY / "src" / package).glob("msg/*.msg")]
    paths = sorted((INCLUDE / package).glob("*.h"))
    assert set(messages) <= {path.stem for path in paths}
    headers = [path.relative_to(INCLUDE) for path in paths if path.name not in NOT_FOR_CPP]
    compiler = shutil.which("g++")
    assert compiler, "g++ is not installed: make setup"
    result = subprocess.run(
        [compiler, "-x", "c++", "-std=c++14", "-fsyntax-only", f"-I{INCLUDE}", "-"],
        input="".join(f"#include <{header}>\n" for header in headers),
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert not result.returncode, result.stderr[:2000]
