"""Lists the passes that rewrite the text before the parse, in the order of running; ``table`` has all others."""

from functools import partial
from typing import Callable, Match, Pattern, Tuple, Union

from utterance_passes import restatements, spelling, typos
from utterance_passes.utterance_pass import (
    Example,
    Stage,
    TextDisfluency,
    TextMeaning,
    TextPass,
    WordDisfluency,
    WordPass,
)
from utterance_passes.vocabulary import Verbs


def _text(
    name: str,
    what: str,
    said: str,
    expected: str,
    pattern: Pattern[str],
    replacement: Union[str, Callable[[Match[str]], str]],
) -> TextPass:
    run = partial(spelling.replaced, pattern=pattern, replacement=replacement)
    return TextPass(name, what, Example(said, (expected,)), Stage.PARSER, run)


#: Rewrite the text alone.
TEXT_PASSES: Tuple[TextPass, ...] = (
    _text(
        "transcribers_marks",
        "Remove the marks of transcribers and speech recognisers.",
        "go <pause> on",
        "go   on",
        spelling.TRANSCRIBERS_MARK,
        " ",
    ),
    _text("apostrophes", "Write all apostrophes alike.", "Bob’s", "Bob's", spelling.APOSTROPHE, "'"),
    TextPass(
        "quotation_marks",
        "Write all quotation marks alike.",
        Example("say “hi” and 'I'm here'", ('say "hi" and "I\'m here"',)),
        Stage.PARSER,
        spelling.with_quotation_marks_alike,
    ),
    _text("dashes", "Write all dashes alike.", "pick–up", "pick-up", spelling.DASH, "-"),
    _text(
        "fraction_signs",
        "Write the sign for a fraction, and digits of another width, in plain digits.",
        "２½",
        "2 1/2",
        spelling.NUMBER_SIGN,
        spelling.number_sign,
    ),
    _text(
        "fraction_slash", "Write the slash in a fraction as a plain one.", "1⁄2", "1/2", spelling.FRACTION_SLASH, "/"
    ),
    _text(
        "degree_sign", "Write the sign for degrees as a word.", "90°", "90 degrees", spelling.DEGREE_SIGN, " degrees"
    ),
    _text("units", "Separate a number from a unit that touches it.", "3ft", "3 ft", spelling.UNIT_AT_NUMBER, " "),
    _text(
        "minus_sign", "Write the sign of a negative number as a word.", "-3", "minus 3", spelling.MINUS_SIGN, "minus "
    ),
    _text(
        "negative_sign",
        'Write "negative" before a number as "minus".',
        "negative two",
        "minus two",
        spelling.NEGATIVE_SIGN,
        "minus ",
    ),
    _text("ratios", "Separate the two numbers of a ratio.", "3/4", "3 / 4", spelling.RATIO, " / "),
    TextDisfluency(
        "false_starts",
        "Remove words that are broken off, and the words that are said again after them.",
        Example("go to the ki- go to the kitchen", ("go to the kitchen",)),
        Stage.PARSER,
        spelling.without_false_starts,
    ),
    TextDisfluency(
        "repeated_starts",
        "Remove the beginning of a phrase that is begun again.",
        Example("go to the go to the office", ("go to the office",)),
        Stage.PARSER,
        spelling.without_repeated_starts,
    ),
    TextDisfluency(
        "half_phrases",
        "Remove a phrase that breaks off before its noun.",
        Example("bring the blue, uh, the green cup", ("bring the green cup",)),
        Stage.PARSER,
        restatements.without_half_a_phrase,
    ),
    TextDisfluency(
        "hesitation",
        "Remove phrases that people say while they think.",
        Example("go to the, you know, kitchen", ("go to the kitchen",)),
        Stage.PARSER,
        spelling.without_hesitation,
    ),
    TextMeaning(
        "shares",
        "Name the things in each share of them.",
        Example("bring two cups, one for me and one for Bob", ("bring one cup for me and one cup for Bob",)),
        Stage.PARSER,
        restatements.with_shares_named,
    ),
    TextPass(
        "contractions",
        "Write contracted words in full.",
        Example("didja move, I'm gonna go", ("did you move, I'm going to go",)),
        Stage.PARSER,
        spelling.written_out,
    ),
    _text("blanks", "Write one blank between words.", "go \t on", "go on", spelling.BLANKS, " "),
    TextPass("ends", "Remove blanks at both ends.", Example(" go ", ("go",)), Stage.PARSER, spelling.stripped),
)

#: Rewrite words that the robot does not know.
WORD_PASSES: Tuple[WordPass, ...] = (
    WordPass(
        "typos",
        "Correct a word with one wrong letter if one word of the lexicon is meant.",
        Example("trun left", ("turn left",), Verbs(frozenset(["turn"]), spellings=frozenset(["turn", "left"]))),
        Stage.PARSER,
        typos.without_typos,
    ),
    WordDisfluency(
        "less_precise",
        "Remove a command that is said again at once, with an amount.",
        Example("turn left turn left two degrees", ("turn left two degrees",), Verbs(frozenset(["turn"]))),
        Stage.PARSER,
        restatements.without_less_precise,
    ),
)
