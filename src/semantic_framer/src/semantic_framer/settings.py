"""Parameters of the semantic framer."""

from dataclasses import dataclass
from typing import Tuple

from roboframenet_ros.parameters import Parameters, parameter
from semantic_framer.behaviour_2012 import Arguments, Questions
from semantic_framer.values.outcome import Alternatives, LeftOverWords, Policy


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters, after validation.

    Attributes:
        lexical_unit_paths: files, and folders with folders named ``lexical_units``
        names_file: file of the names that the robot knows, with their semantic types; empty for none
        left_over_words: what to do with words that a reading does not account for
        alternatives: what to do with "or"
        question_timeout_s: how long a question may be answered, seconds
        fragment_timeout_s: how long a fragment ("again") may change or repeat the last command, seconds; 0 for never
        trace: whether each stage event includes the trace of the rules
        arguments: which words become arguments
        questions: what to do if the framer needs to know something first; if it must not ask, no frame wants a yes
        learned_file: where it is kept what persons teach; empty for ``learned.sqlite`` in the ROS home folder
        speaker: id of the person who speaks until the topic ``speaker`` says another; empty: nobody known

    Raises:
        ParameterError: a value is not allowed
    """

    lexical_unit_paths: Tuple[str, ...] = parameter((), may_be_single=True)
    names_file: str = parameter("")
    left_over_words: LeftOverWords = parameter(Policy.left_over_words)
    alternatives: Alternatives = parameter(Policy.alternatives)
    question_timeout_s: float = parameter(Policy.question_timeout_s, least=1.0, most=3600.0)
    fragment_timeout_s: float = parameter(Policy.fragment_timeout_s, least=0.0, most=3600.0)
    trace: bool = parameter(True)
    arguments: Arguments = parameter(Arguments.PHRASES)
    questions: Questions = parameter(Questions.ASK)
    learned_file: str = parameter("")
    speaker: str = parameter("")

    @property
    def policy(self) -> Policy:
        """How careful the framer is."""
        return Policy(
            left_over_words=self.left_over_words,
            alternatives=self.alternatives,
            question_timeout_s=self.question_timeout_s,
            fragment_timeout_s=self.fragment_timeout_s,
            confirms=self.questions is Questions.ASK,
        )
