"""XML-RPC over HTTP with a deadline."""

import http.client
import xmlrpc.client
from collections import OrderedDict
from typing import Any, Dict, Tuple, Union


class TimedTransport(xmlrpc.client.Transport):
    """HTTP with a deadline for a host that does not answer."""

    #: To compress what stays on one machine, or in one room, takes longer than to send it.
    accept_gzip_encoding = False

    def __init__(self, timeout_s: float) -> None:
        """Set the deadline of each connection, seconds."""
        super().__init__()
        self._timeout_s = timeout_s

    def make_connection(self, host: Union[str, Tuple[str, Dict[str, str]]]) -> http.client.HTTPConnection:
        """Connect with the deadline."""
        connection = super().make_connection(host)
        connection.timeout = self._timeout_s
        return connection


class RememberingTransport(TimedTransport):
    """Parses an answer once: for one that came before, it gives the same objects again, which nobody may change.

    The master tells the whole graph each time that it is asked, and the graph seldom changes.
    """

    #: Answers that are remembered; a user asks the master two or three questions in turn.
    _MOST = 4

    def __init__(self, timeout_s: float) -> None:
        """Set the deadline of each connection, seconds."""
        super().__init__(timeout_s)
        self._answers: OrderedDict[bytes, Tuple[Any, ...]] = OrderedDict()

    def parse_response(self, response: http.client.HTTPResponse) -> Tuple[Any, ...]:
        """Return the answer in a response.

        Raises:
            xmlrpc.client.Fault: the other side reports an error
        """
        body = response.read()
        answer = self._answers.pop(body, None)
        if answer is None:
            parser, target = self.getparser()
            parser.feed(body)
            parser.close()
            answer = target.close()
        self._answers[body] = answer
        if len(self._answers) > self._MOST:
            self._answers.popitem(last=False)
        return answer
