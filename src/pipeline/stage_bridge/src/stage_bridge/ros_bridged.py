"""The stages that can be outside: what they are sent, what they answer, and what becomes of it."""

from dataclasses import dataclass
from enum import Enum
from typing import Any, Callable, Mapping

from roboframenet_msgs.msg import (
    Command,
    CommandLexicalUnits,
    CommandParse,
    CommandPlan,
    CommandSemanticFrames,
    FilledLexicalUnitList,
    FilledSemanticFrameListList,
    Procedure,
)
from stanford_parser_msgs.msg import Parse
from std_msgs.msg import String

from stage_bridge.ros_conversion import (
    Registered,
    candidates_of,
    clause_of,
    frames_sent,
    ordered_plan,
    plan_of,
    units_sent,
)


class Outside(Enum):
    """What is outside."""

    LANGUAGE = "language"
    FRAMER = "framer"
    REGISTRAR = "registrar"
    ARBITRATOR = "arbitrator"


@dataclass(frozen=True)
class Bridged:
    """A stage that is outside.

    Attributes:
        stage: that answers in our place, by its name in events
        heard: topic of what our stage before it publishes, and its type
        asked: topic of 2012 on which the stage outside is asked, and its type
        answers: topic of 2012 on which it answers, and its type
        told: topic that our next stage hears, and its type
        question: makes what is asked; raises NotIn2012
        outcome: makes what the next stage hears, of what came before, the answer and the registered servers; raises
            NoAnswer, WrongAnswer
    """

    stage: str
    heard: str
    heard_type: Any
    asked: str
    asked_type: Any
    answers: str
    answers_type: Any
    told: str
    told_type: Any
    question: Callable[[Any], Any]
    outcome: Callable[[Any, Any, Registered], Any]


def command_in(message: Any) -> Command:
    """Return the command of a message between our stages."""
    return message if isinstance(message, Command) else message.command


def _units(message: Any, answer: FilledLexicalUnitList, _registered: Registered) -> CommandLexicalUnits:
    command = command_in(message)
    return CommandLexicalUnits(command=command, clauses=[clause_of(answer, command.text)])


def _frames(
    message: CommandLexicalUnits, answer: FilledSemanticFrameListList, registered: Registered
) -> CommandSemanticFrames:
    plan = plan_of(candidates_of(answer, registered), message.command.text, message.plan.beginning)
    return CommandSemanticFrames(command=message.command, plan=plan)


def _plan(message: CommandSemanticFrames, answer: Procedure, registered: Registered) -> CommandPlan:
    return CommandPlan(
        command=message.command, plan=ordered_plan(message.plan, answer, registered, message.command.text)
    )


def _framer(heard: str, heard_type: Any, asked: str, asked_type: Any, question: Callable[[Any], Any]) -> Bridged:
    return Bridged(
        "semantic_framer",
        heard,
        heard_type,
        asked,
        asked_type,
        "filled_lexical_units",
        FilledLexicalUnitList,
        "command_lexical_units",
        CommandLexicalUnits,
        question,
        _units,
    )


BRIDGED: Mapping[Outside, Bridged] = {
    Outside.LANGUAGE: _framer("command_text", Command, "text", String, lambda command: String(command.text)),
    Outside.FRAMER: _framer("command_parse", CommandParse, "parse", Parse, lambda message: message.parse),
    Outside.REGISTRAR: Bridged(
        "frame_registrar",
        "command_lexical_units",
        CommandLexicalUnits,
        "filled_lexical_units",
        FilledLexicalUnitList,
        "filled_semantic_frames",
        FilledSemanticFrameListList,
        "command_semantic_frames",
        CommandSemanticFrames,
        units_sent,
        _frames,
    ),
    Outside.ARBITRATOR: Bridged(
        "arbitrator",
        "command_semantic_frames",
        CommandSemanticFrames,
        "filled_semantic_frames",
        FilledSemanticFrameListList,
        "procedure",
        Procedure,
        "command_plan",
        CommandPlan,
        lambda message: frames_sent(message.plan),
        _plan,
    ),
}
