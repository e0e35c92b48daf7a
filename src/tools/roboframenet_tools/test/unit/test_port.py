"""The one-line change of existing servers, in the shapes in which people write them."""

import os
import stat

import pytest

from roboframenet_tools.cli import main
from roboframenet_tools.port import AlreadyPorted, PortError, port

FIBONACCI = """#! /usr/bin/env python
import roslib; roslib.load_manifest('actionlib_tutorials')
import rospy

import actionlib

import actionlib_tutorials.msg

class FibonacciAction(object):
  # create messages that are used to publish feedback/result
  _feedback = actionlib_tutorials.msg.FibonacciFeedback()

  def __init__(self, name):
    self._action_name = name
    self._as = actionlib.SimpleActionServer(self._action_name, actionlib_tutorials.msg.FibonacciAction, execute_cb=self.execute_cb, auto_start = False)
    self._as.start()

  def execute_cb(self, goal):
    self._as.set_succeeded()

if __name__ == '__main__':
  rospy.init_node('fibonacci')
  server = FibonacciAction(rospy.get_name())
  rospy.spin()
"""  # noqa: E501 (laid out as its authors did)
AVERAGING = '''"""Averages."""
import rospy
from actionlib import SimpleActionServer
from actionlib_tutorials.msg import AveragingAction


class Averaging:
    def __init__(self):
        self.server = SimpleActionServer("averaging", AveragingAction, auto_start=False)
        self.server.register_goal_callback(self.goal_cb)
        self.server.register_preempt_callback(self.preempt_cb)
        self.server.start()
'''


def changed(before, after):
    """Lines that went, and lines that came."""
    old, new = before.splitlines(), after.splitlines()
    return [line for line in old if line not in new], [line for line in new if line not in old]


def test_fibonacci_changes_in_one_line_and_an_import():
    ported = port(FIBONACCI)
    gone, came = changed(FIBONACCI, ported.text)
    assert len(gone) == 1
    assert came == ["import rfnserver", gone[0].replace("actionlib.SimpleActionServer", "rfnserver.RFNServer")]
    lines = ported.text.splitlines()
    assert lines[lines.index("import rfnserver") - 1] == "import actionlib_tutorials.msg"
    assert ported.servers == ("self._as",)
    compile(ported.text, "fibonacci", "exec")


def test_averaging_with_goal_callback():
    ported = port(AVERAGING)
    assert changed(AVERAGING, ported.text) == (
        ['        self.server = SimpleActionServer("averaging", AveragingAction, auto_start=False)'],
        [
            "import rfnserver",
            '        self.server = rfnserver.RFNServer("averaging", AveragingAction, auto_start=False)',
        ],
    )


@pytest.mark.parametrize(
    "statement,expression",
    [
        ("import actionlib", "actionlib.SimpleActionServer"),
        ("import actionlib as al", "al.SimpleActionServer"),
        ("import actionlib", "actionlib.simple_action_server.SimpleActionServer"),
        ("import actionlib.simple_action_server", "actionlib.simple_action_server.SimpleActionServer"),
        ("import actionlib.simple_action_server as sas", "sas.SimpleActionServer"),
        ("from actionlib import SimpleActionServer", "SimpleActionServer"),
        ("from actionlib import SimpleActionServer as Server", "Server"),
        ("from actionlib import simple_action_server", "simple_action_server.SimpleActionServer"),
        ("from actionlib.simple_action_server import SimpleActionServer as S", "S"),
        ("from actionlib import *", "SimpleActionServer"),
        ("from actionlib.simple_action_server import *", "SimpleActionServer"),
    ],
)
def test_every_way_to_import(statement, expression):
    source = f"{statement}\ns = {expression}('a', A, execute_cb=f)\n"
    assert port(source).text == f"{statement}\nimport rfnserver\ns = rfnserver.RFNServer('a', A, execute_cb=f)\n"


@pytest.mark.parametrize(
    "statement,expression",
    [
        ("import actionlib", "actionlib.ActionServer"),
        ("from actionlib import ActionServer", "ActionServer"),
        ("import actionlib", "actionlib.action_server.ActionServer"),
        ("from actionlib import action_server", "action_server.ActionServer"),
    ],
)
def test_plain_action_server(statement, expression):
    source = f"{statement}\ns = {expression}('a', A, goal_cb, cancel_cb, auto_start=False)\n"
    assert port(source).text == (
        f"{statement}\nimport rfnserver\ns = rfnserver.RFNActionServer('a', A, goal_cb, cancel_cb, auto_start=False)\n"
    )


def test_subclass_changes_its_base_and_the_calls_of_it():
    source = (
        "import actionlib\n\n\nclass Fib(actionlib.SimpleActionServer, Other):\n    def __init__(self):\n"
        "        actionlib.SimpleActionServer.__init__(self, 'fib', A, self.do, False)\n\n\nserver = Fib()\n"
        "assert isinstance(server, actionlib.SimpleActionServer)\n"
    )
    ported = port(source)
    assert changed(source, ported.text)[1] == [
        "import rfnserver",
        "class Fib(rfnserver.RFNServer, Other):",
        "        rfnserver.RFNServer.__init__(self, 'fib', A, self.do, False)",
    ]
    assert ported.servers == ("self",)


def test_class_in_a_class_and_another_name_for_the_class():
    source = (
        "from actionlib import SimpleActionServer as S\nServer = S\n\n\nclass A(S):\n    class B(S):\n"
        "        def start(self):\n            S.start(self)\n"
    )
    assert port(source).text == source.replace("as S\n", "as S\nimport rfnserver\n").replace(
        "= S\n", "= rfnserver.RFNServer\n"
    ).replace("(S)", "(rfnserver.RFNServer)").replace(" S.", " rfnserver.RFNServer.")


def test_several_servers_on_lines_of_their_own_and_of_one_line():
    source = (
        "from actionlib import ActionServer, SimpleActionServer\n"
        "a = SimpleActionServer('ä', A); b = SimpleActionServer('b', B)\n"
        "both = [ActionServer('ö', C, g), SimpleActionServer('d', D)]\n"
        "self.c: SimpleActionServer = SimpleActionServer(\n    'c', C)\n"
    )
    ported = port(source)
    assert ported.text == (
        "from actionlib import ActionServer, SimpleActionServer\nimport rfnserver\n"
        "a = rfnserver.RFNServer('ä', A); b = rfnserver.RFNServer('b', B)\n"
        "both = [rfnserver.RFNActionServer('ö', C, g), rfnserver.RFNServer('d', D)]\n"
        "self.c: SimpleActionServer = rfnserver.RFNServer(\n    'c', C)\n"
    )
    assert ported.servers == ("a", "b", "self.c")


def test_class_that_is_passed_on():
    source = (
        "from functools import partial\nimport actionlib\n\n\n"
        "def make(kind=actionlib.SimpleActionServer):\n    return kind('a', A, auto_start=False)\n\n\n"
        "make_b = partial(actionlib.SimpleActionServer, 'b', B)\nkinds = {'plain': actionlib.ActionServer}\n"
    )
    assert changed(source, port(source).text)[1] == [
        "import rfnserver",
        "def make(kind=rfnserver.RFNServer):",
        "make_b = partial(rfnserver.RFNServer, 'b', B)",
        "kinds = {'plain': rfnserver.RFNActionServer}",
    ]


def test_expression_over_several_lines():
    source = "import actionlib\ns = (actionlib\n     .SimpleActionServer)('a', A)\nt = 1\n"
    assert port(source).text == "import actionlib\nimport rfnserver\ns = (rfnserver.RFNServer)('a', A)\nt = 1\n"


@pytest.mark.parametrize(
    "head,expected",
    [
        (
            "#!/usr/bin/python3\n# -*- coding: utf-8 -*-\n",
            "#!/usr/bin/python3\n# -*- coding: utf-8 -*-\nimport rfnserver\n",
        ),
        ('"""Doc."""\n', '"""Doc."""\nimport rfnserver\n'),
        ("from __future__ import print_function\n", "from __future__ import print_function\nimport rfnserver\n"),
        ("import a; a.load(\n    'x')\n", "import a; a.load(\n    'x')\nimport rfnserver\n"),
        ("import a, \\\n    b\n", "import a, \\\n    b\nimport rfnserver\n"),
    ],
)
def test_place_of_the_import(head, expected):
    body = "def main():\n    import actionlib\n    return actionlib.SimpleActionServer('a', A)\n\n\nimport late\n"
    assert port(head + body).text == expected + body.replace("actionlib.S", "S").replace(
        "SimpleAction", "rfnserver.RFN"
    )


@pytest.mark.parametrize(
    "statement,module",
    [("import rfnserver", "rfnserver"), ("import rfnserver as r", "r"), ("import rfnserver.arguments", "rfnserver")],
)
def test_import_that_is_there_already(statement, module):
    source = (
        f"import actionlib\n{statement}\ns = actionlib.SimpleActionServer('a', A)\nr0 = {module}.RFNServer('b', f)\n"
    )
    assert port(source).text == source.replace("actionlib.SimpleActionServer", f"{module}.RFNServer")


@pytest.mark.parametrize(
    "source,reason",
    [
        ("print 'hello'\n", "line 1.*not Python 3"),
        ("x = 1\0\n", "no Python"),
        ("import actionlib\nc = actionlib.SimpleActionClient('a', A)\n", "it does not make an action server"),
        ("from vendor import SimpleActionServer\ns = SimpleActionServer('a', A)\n", "it does not make"),
        ("from .actionlib import SimpleActionServer\ns = SimpleActionServer('a', A)\n", "it does not make"),
        ("import actionlib\nrfnserver = actionlib.SimpleActionServer('a', A)\n", "line 2: the name rfnserver"),
        (
            "import actionlib\nfrom robot import rfnserver\ns = actionlib.SimpleActionServer('a', A)\n",
            "line 2: the name",
        ),
    ],
)
def test_what_cannot_be_ported_is_said_in_one_sentence(source, reason):
    with pytest.raises(PortError, match=reason) as error:
        port(source)
    assert not isinstance(error.value, AlreadyPorted)


@pytest.mark.parametrize(
    "source",
    [
        "import rfnserver\ns = rfnserver.RFNServer('a', f)\n",
        "from rfnserver import RFNServer\nclass A(RFNServer): pass\n",
    ],
)
def test_ported_already(source):
    with pytest.raises(AlreadyPorted):
        port(source)


def test_ported_text_has_nothing_left_to_port():
    for source in (FIBONACCI, AVERAGING):
        with pytest.raises(AlreadyPorted):
            port(port(source).text)


# The command


def test_diff_is_shown_and_nothing_is_written(tmp_path, capsys):
    path = tmp_path / "fibonacci_server.py"
    path.write_text(FIBONACCI)
    assert main(["port", str(path)]) == 0
    shown = capsys.readouterr().out
    assert path.read_text() == FIBONACCI
    assert "+import rfnserver\n" in shown and 'self._as.register_with_frame("frame_name")' in shown
    assert sum(line.startswith("-") for line in shown.splitlines()) == 2, "the file's name, and one line"
    diff = [line for line in shown.splitlines() if line.startswith(("+", "-")) and line[:3] not in ("+++", "---")]
    ported = port(FIBONACCI).text.splitlines()
    assert [line[1:] for line in diff if line[0] == "+"] == [
        line for line in ported if line not in FIBONACCI.splitlines()
    ]
    assert [line[1:] for line in diff if line[0] == "-"] == [
        line for line in FIBONACCI.splitlines() if line not in ported
    ]


def test_apply_keeps_line_ends_encoding_mode_and_link(tmp_path, capsys):
    target, link = tmp_path / "server.py", tmp_path / "link.py"
    source = ("# -*- coding: latin-1 -*-\n" + AVERAGING.replace("Averages", "Mittelwerte für alle")).replace(
        "\n", "\r\n"
    )
    target.write_bytes(source.encode("latin-1"))
    target.chmod(0o750)
    link.symlink_to(target)
    assert main(["port", str(link), "--apply"]) == 0
    assert "is changed" in capsys.readouterr().out
    assert target.read_bytes() == (
        source.replace("SimpleActionServer(", "rfnserver.RFNServer(")
        .replace("import AveragingAction\r\n", "import AveragingAction\r\nimport rfnserver\r\n")
        .encode("latin-1")
    )
    assert link.is_symlink() and stat.S_IMODE(target.stat().st_mode) == 0o750
    assert sorted(os.listdir(str(tmp_path))) == ["link.py", "server.py"]
    assert main(["port", str(link), "--apply"]) == 0
    assert "already" in capsys.readouterr().out


def test_byte_order_mark_and_missing_last_line_end(tmp_path, capsys):
    path = tmp_path / "server.py"
    path.write_bytes(b"\xef\xbb\xbfimport actionlib\ns = actionlib.SimpleActionServer('a', A)")
    assert main(["port", str(path), "--apply"]) == 0
    assert "\\ No newline at end of file" in capsys.readouterr().out
    assert path.read_bytes() == b"\xef\xbb\xbfimport actionlib\nimport rfnserver\ns = rfnserver.RFNServer('a', A)"


@pytest.mark.parametrize("content", [b"x = 1\n", b"print 'x'\n", b"# \xff\n", b"# coding: nothing\n"])
def test_status_of_a_file_that_cannot_be_ported(tmp_path, capsys, content):
    path = tmp_path / "server.py"
    path.write_bytes(content)
    assert main(["port", str(path), "--apply"]) == 1
    assert path.read_bytes() == content
    printed = capsys.readouterr()
    assert printed.out == "" and len(printed.err.splitlines()) == 1


def test_status_of_a_missing_file(tmp_path, capsys):
    assert main(["port", str(tmp_path / "nowhere.py")]) == 2
    assert "no file" in capsys.readouterr().err
