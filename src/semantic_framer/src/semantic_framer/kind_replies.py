"""What is answered to an utterance that asks for nothing to be done."""

from typing import Tuple

from semantic_framer.mood_words import TALK_REPLIES
from semantic_framer.utterance_kind import KindVerdict, UtteranceKind


def reply_to(verdict: KindVerdict, said: str) -> Tuple[str, str]:
    """Return the code and the sentence of the reply.

    Args:
        verdict: of an utterance that does not act, and is no prohibition
        said: its words
    """
    if verdict.kind is UtteranceKind.QUESTION:
        return "QUESTION", f'"{said}" is a question, and I can only carry out commands.'
    if verdict.kind is UtteranceKind.WISH:
        return "WISH", f'"{said}" is what you want to do yourself. Tell me what I am to do.'
    if verdict.kind is UtteranceKind.REPORT:
        return "REPORT", f'"{said}" does not ask me to do anything.'
    return "TALK", TALK_REPLIES.get(verdict.reason, "I hear you.")
