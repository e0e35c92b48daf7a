"""The command line of a host."""

import pytest

from server_hosting.hosted import Hosted, HostedError, read_hosted


def test_servers_are_read_and_what_roslaunch_appends_is_not() -> None:
    hosted = read_hosted(["moo=moo.node:MooServer", "__name:=host", "utter=utter.node:UtterServer"])
    assert hosted == (Hosted("moo", "moo.node", "MooServer"), Hosted("utter", "utter.node", "UtterServer"))
    assert hosted[0].parameters == "~moo/"


@pytest.mark.parametrize(
    "arguments",
    [[], ["moo"], ["moo=moo.node"], ["moo=moo.node:"], ["=a:B"], ["a=a:B", "a=b:C"], ["a=os.system('x'):B"]],
)
def test_anything_else_is_refused(arguments: list) -> None:
    with pytest.raises(HostedError):
        read_hosted(arguments)
