"""The messages have C++ headers that compile: a program in C++ can be a client of the action ``command``."""

import re
import shutil
import subprocess

from roboframenet_testing.workspace import REPOSITORY, packages

INCLUDE = REPOSITORY / "devel" / "include"
PACKAGES = ("roboframenet_msgs", "stanford_parser_msgs")
#: A message of 2012 has a field "default", which is a keyword of C++; and its sum must not change.
NOT_FOR_CPP = ("EmptyFrameElement.h", "EmptySemanticFrame.h", "GetEmptyFrame.h", "GetEmptyFrameResponse.h")


def test_headers_and_the_documented_client_compile() -> None:
    """In one run of the compiler: each would read most of the headers of ROS."""
    headers = []
    for package in PACKAGES:
        messages = [path.stem for path in packages()[package].glob("msg/*.msg")]
        paths = sorted((INCLUDE / package).glob("*.h"))
        assert set(messages) <= {path.stem for path in paths}
        headers += [path.relative_to(INCLUDE) for path in paths if path.name not in NOT_FOR_CPP]
    text = (REPOSITORY / "docs" / "interfaces.md").read_text(encoding="utf-8")
    (program,) = re.findall(r"^```cpp\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    # The client first: it includes itself all that it needs.
    assert not errors_in(program + "".join(f"#include <{header}>\n" for header in headers))


def test_what_does_not_compile_is_found() -> None:
    assert "no_such_header" in errors_in("#include <no_such_header.h>\n")


def errors_in(program: str) -> str:
    """Return the beginning of what the compiler says about a program; empty when it compiles."""
    compiler = shutil.which("g++")
    assert compiler, "g++ is not installed: make setup"
    result = subprocess.run(
        [compiler, "-x", "c++", "-std=c++14", "-fsyntax-only", f"-I{INCLUDE}", "-"],
        input=program,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    return result.stderr[:2000] if result.returncode else ""
