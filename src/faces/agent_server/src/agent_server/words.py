"""What an agent may say, and what only a person may."""

from dataclasses import dataclass
from typing import Optional

from agent_server.refused import CallRefused
from command_server.emergency_words import is_release
from command_server.orders_back import said_behind
from command_server.stop_words import find_cry
from word_classes.short_answers import agreement

#: How long a question of the robot may be answered, seconds: that of the framer.
QUESTION_S = 60.0
#: Codes of questions that ask for a yes or a no.
YES_OR_NO = ("CONFIRM", "LEFT_OVER_WORDS")
#: Why an agent does not release the emergency stop.
RELEASE_REFUSED = "The emergency stop is released by a person who has looked at the robot, and by no agent."


@dataclass(frozen=True)
class OpenQuestion:
    """The last question of the robot, while its next utterance may be the answer.

    Attributes:
        command_id: of the command that it was the reply to
        code: what kind of question it is
        asked_s: when it was asked, monotonic seconds
    """

    command_id: str
    code: str
    asked_s: float


def check_said(text: str, question: Optional[OpenQuestion], *, own_prefix: str, now_s: float) -> None:
    """Check a sentence of an agent.

    Args:
        text: the sentence
        question: that the robot has asked last; None when it has asked nothing since
        own_prefix: the ids of the commands of this agent begin with it
        now_s: monotonic seconds
    Raises:
        CallRefused: only a person may say it, or it could be taken for a person's answer
    """
    if is_release(text):
        raise CallRefused("EMERGENCY_STOP", RELEASE_REFUSED)
    if agreement(text) is not None:
        raise CallRefused("NOT_A_PERSON", "A yes or a no is for a person to say; the robot asks where it needs one.")
    cry = find_cry(text)
    if cry is not None and said_behind(cry):
        raise CallRefused("REST_NOT_DONE", "A stop stands alone: call stop, and then what shall be done.")
    is_open = question is not None and now_s < question.asked_s + QUESTION_S
    is_own = question is not None and question.command_id.startswith(own_prefix) and question.code not in YES_OR_NO
    if question is not None and is_open and not is_own:
        left_s = question.asked_s + QUESTION_S - now_s
        raise CallRefused("BUSY", f"The robot has asked a person, and waits for the answer for at most {left_s:.0f} s.")
