"""Formulas: each does with its example what the file says, and what is said of a wrong file."""

import re
from typing import List, Pattern, Tuple

import pytest

from checked_files import FileRefused, Problem
from utterance_passes.asides.comparisons import comparisons
from utterance_passes.asides.formulas import formulas
from utterance_passes.asides.objections import objection
from utterance_passes.slips.corrections import corrections
from utterance_passes.slips.hesitation import hesitation
from utterance_passes.trees.formula_file import KINDS, Formula, load_formulas, shipped_formulas
from utterance_passes.trees.spelling import as_said
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.vocabulary import Verbs
from utterance_passes.wording.surroundings import surroundings
from utterance_passes.wording.written_signs import contractions

_VERBS = Verbs(frozenset(["turn"]), lists={"turn": (("left", "right"),)})
_SHIPPED = [(kind, formula) for kind in KINDS for formula in shipped_formulas()[kind]]


def _forms(text: str) -> List[str]:
    return re.findall(r"n't|'\w+|[a-z]+?(?=n't)|\w+|,", text, re.IGNORECASE)


def tree_of(text: str) -> DependencyTree:
    """A tree of the words as the parser divides them, all on the verb."""
    forms = _forms(text)
    verb = 1 + forms.index("turn")
    words = tuple(
        Word(
            index,
            form,
            form.lower(),
            "VERB" if index == verb else "PUNCT" if form == "," else "ADV",
            "",
            "",
            0 if index == verb else verb,
            "root" if index == verb else "advmod",
        )
        for index, form in enumerate(forms, start=1)
    )
    return DependencyTree(text, words)


#: Kinds of which the parser leaves out what is said around a command.
_AROUND = ("openings", "modal_openings", "gerund_openings", "tails", "set_off_tails")


def left_of(kind: str, text: str) -> str:
    """What the pass of a kind leaves of a sentence."""
    if kind == "contractions":
        return contractions.run(as_said(text)).text
    if kind == "phrases_of_hesitation":
        return " ".join(hesitation.run(as_said(text)).text.split())
    if kind in _AROUND:
        around = surroundings.run(as_said(text), _VERBS)
        return around.command.text.lower() if around is not None else text
    tree = tree_of(text)
    if kind == "fillers":
        return " ".join(word.form for word in tree.words if word.index not in tree.fillers)
    if kind in ("editing_terms", "withdrawals"):
        tree = corrections.run(tree, _VERBS)
    elif kind == "comparisons":
        tree = comparisons.run(tree, _VERBS)
    elif kind == "objections":
        tree = objection.run(tree, _VERBS)
    else:
        tree = formulas.run(tree, _VERBS)
    return " ".join(word.form for word in tree.open_words if word.upos != "PUNCT")


def phrases_of(kind: str, text: str) -> List[str]:
    """The words of a text that a formula of a kind may be: the first ones, the last ones, or any."""
    forms = [form.lower() for form in _forms(text) if form != ","]
    starts = (0,) if kind.endswith("openings") else range(len(forms))
    ends = (len(forms),) if kind.endswith("tails") else range(1, len(forms) + 1)
    return [" ".join(forms[start:end]) for end in ends for start in starts if start < end]


def is_in(kind: str, pattern: Pattern[str], text: str) -> bool:
    """Whether a formula of a kind is said in a text."""
    if kind == "contractions":
        return re.search(rf"(?<![\w'])(?:{pattern.pattern})(?![\w'])", text, re.IGNORECASE) is not None
    return any(pattern.fullmatch(phrase) for phrase in phrases_of(kind, text))


@pytest.mark.parametrize("kind, formula", _SHIPPED, ids=lambda value: getattr(value, "example", value))
def test_an_example_becomes_what_the_file_says(kind: str, formula: Formula) -> None:
    assert left_of(kind, formula.example) == formula.becomes


@pytest.mark.parametrize("kind, formula", _SHIPPED, ids=lambda value: getattr(value, "example", value))
def test_an_example_is_of_its_own_formula(kind: str, formula: Formula) -> None:
    matching = [
        other.pattern.pattern for other in shipped_formulas()[kind] if is_in(kind, other.pattern, formula.example)
    ]
    assert matching == [formula.pattern.pattern]


def test_an_example_without_its_formula_stays() -> None:
    assert left_of("openings", "whistle and turn left") == "whistle and turn left"


def test_a_class_stands_for_its_words() -> None:
    formula = formulas_with("do <not> forget to")[0]
    assert formula.pattern.fullmatch("do n't forget to") and not formula.pattern.fullmatch("do never forget to")


def text_with(entry: str) -> str:
    usual = "[{pattern: so, example: so go, becomes: go}]"
    in_full = "[{pattern: dont, example: dont go, becomes: don't go, written: don't}]"
    others = {kind: in_full if kind == "contractions" else usual for kind in KINDS}
    return "\n".join(f"{kind}: {content}" for kind, content in {**others, "openings": entry}.items())


def formulas_with(pattern: str) -> Tuple[Formula, ...]:
    return load_formulas(text_with(f'[{{pattern: "{pattern}", example: a, becomes: b}}]'), "formulas.yaml")["openings"]


@pytest.mark.parametrize(
    "entry, code, key",
    [
        ('[{pattern: "<nots>", example: a, becomes: b}]', "UNKNOWN_CLASS", "openings[0].pattern"),
        ('[{pattern: "(so", example: a, becomes: b}]', "BAD_PATTERN", "openings[0].pattern"),
        ('[{pattern: "Please", example: a, becomes: b}]', "NOT_LOWER_CASE", "openings[0].pattern"),
        ("[{pattern: so, becomes: b}]", "MISSING_KEY", "openings[0].example"),
        ("[]", "EMPTY", "openings"),
        ("so", "WRONG_TYPE", "openings"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(entry: str, code: str, key: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_formulas(text_with(entry), "formulas.yaml")
    problem: Problem = refused.value.problems[0]
    assert (problem.code, problem.line, problem.key) == (code, 1, key)


def test_a_kind_that_is_missing_is_named() -> None:
    with pytest.raises(FileRefused, match="MISSING_KEY fillers"):
        load_formulas("openings: [{pattern: so, example: a, becomes: b}]", "formulas.yaml")
