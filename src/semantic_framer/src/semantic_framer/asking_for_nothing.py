"""Replies to utterances that only ask or tell something."""

from semantic_framer.outcome import QUESTION, REPORT, TALK, WISH, Refusal
from semantic_framer.utterance_kind import KindVerdict

_REPLIES = {
    QUESTION: 'I do not know how to answer "{said}".',
    REPORT: '"{said}" does not ask me to do anything.',
    WISH: '"{said}" is something that you want to do. Tell me what I should do.',
    TALK: "I hear you. There is nothing for me to do.",
}
#: Replies to talk, by the name of the rule that classified it as talk.
_REPLIES_TO_TALK = {"thanks": "You are welcome.", "greeting": "Hello."}


def asks_for_nothing(kind: KindVerdict, said: str) -> Refusal:
    """Return the refusal of an utterance that only asks or tells something.

    Args:
        kind: its kind
        said: its words
    """
    code = kind.kind.name
    reply = _REPLIES_TO_TALK.get(kind.reason, _REPLIES[code])
    return Refusal(code, reply.format(said=said))
