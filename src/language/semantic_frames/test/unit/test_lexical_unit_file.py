"""Lexical unit files: what loads, and what is said of those that do not."""

import pytest

from semantic_frames import FileRefused, check_lexical_unit, load_frame, load_lexical_units
from semantic_frames.lexical_unit import ArgumentForm, HeldState
from semantic_frames.relation_names import is_relation_name

GIVING_2012 = """\
frame_name: giving
verb: give
frame_element_grammatical_relations:
  - name: recipient
    relation: iobj
  - name: theme
    relation: dobj
"""
GIVING = load_frame(
    "name: giving\nframe_elements:\n  - {name: recipient, is_core: True}\n  - {name: theme, is_core: True}\n", "g.yaml"
)


def test_file_of_2012_loads_unchanged() -> None:
    (unit,) = load_lexical_units(GIVING_2012, "give.yaml")
    assert (unit.frame_name, unit.verbs) == ("giving", ("give",))
    assert [str(relation.relations[0]) for relation in unit.relations] == ["iobj", "dobj"]


def test_verbs_of_a_class_stand_for_a_verb_of_the_unit() -> None:
    (unit,) = load_lexical_units("frame_name: taking\nverb: [get, pick up]\nverb_class: {obtain: get.v.01}\n", "u.yaml")
    assert unit.verbs == ("get", "pick up", "obtain")
    assert (unit.stands_for("obtain"), unit.stands_for("get")) == ("get", "")


@pytest.mark.parametrize("listed", ["{obtain: get}", "{obtain: own.v.01}", "{get: get.v.01}"])
def test_a_verb_of_a_class_needs_a_sense_of_another_verb_of_the_unit(listed: str) -> None:
    with pytest.raises(FileRefused, match="NOT_A_SENSE"):
        load_lexical_units(f"frame_name: taking\nverb: get\nverb_class: {listed}\n", "u.yaml")


def test_list_of_units_chains_and_alternatives() -> None:
    units = load_lexical_units(
        "- frame_name: a\n  verb: [go, Walk  up]\n  frame_element_grammatical_relations:\n"
        "    - name: x\n      relation: [dobj/poss, prep_of]\n      argument: phrase\n      words: [On]\n"
        "      required: True\n      after_place: [On, in]\n"
        "  examples:\n    - text: Go.\n      frame_elements: {x: y}\n- frame_name: b\n  verb: come\n",
        "u.yaml",
    )
    assert units[0].verbs == ("go", "walk up")
    relation = units[0].relations[0]
    assert [path.steps for path in relation.relations] == [("dobj", "poss"), ("prep_of",)]
    assert (relation.argument, relation.words, relation.is_required) == (ArgumentForm.PHRASE, ("on",), True)
    assert relation.after_place == ("on", "in")
    assert units[0].examples[0].frame_elements == {"x": "y"}


@pytest.mark.parametrize(
    "text, code, line, key",
    [
        ("", "EMPTY", 1, "file"),
        ("[]", "EMPTY", 1, "file"),
        ("frame_name: a", "MISSING_KEY", 1, "verb"),
        ("frame_name: a\nverb:", "EMPTY", 2, "verb"),
        ("frame_name: a\nverb: go\nverb: come", "DUPLICATE_KEY", 3, "verb"),
        ("frame_name: a\nverbs: go", "UNKNOWN_KEY", 2, "verbs"),
        (
            (
                "frame_name: a\nverb: go\nframe_element_grammatical_relations:\n"
                "  - {name: x, relation: dobj, semantic_type: Contaner}"
            ),
            "UNKNOWN_TYPE",
            4,
            "frame_element_grammatical_relations[0].semantic_type",
        ),
        (
            "frame_name: a\nverb: go\nframe_element_grammatical_relations:\n  - {name: x, relation: dirobj}",
            "UNKNOWN_RELATION",
            4,
            "frame_element_grammatical_relations[0].relation",
        ),
        (
            "frame_name: a\nverb: go\nframe_element_grammatical_relations:\n  - {name: x}",
            "MISSING_KEY",
            4,
            "frame_element_grammatical_relations[0].relation",
        ),
        (
            (
                "frame_name: a\nverb: go\nframe_element_grammatical_relations:\n"
                "  - {name: x, relation: dobj, argument: word}"
            ),
            "UNKNOWN_VALUE",
            4,
            "frame_element_grammatical_relations[0].argument",
        ),
        (
            (
                "frame_name: a\nverb: go\nframe_element_grammatical_relations:\n"
                "  - name: x\n    relation:\n      - dobj\n      - dirobj\n"
            ),
            "UNKNOWN_RELATION",
            7,
            "frame_element_grammatical_relations[0].relation[1]",
        ),
        (
            "frame_name: a\nverb: go\nframe_element_grammatical_relations:\n  - {name: x, relation: {dobj: poss}}",
            "WRONG_TYPE",
            4,
            "frame_element_grammatical_relations[0].relation",
        ),
        (
            "frame_name: a\nverb: go\nframe_element_grammatical_relations:\n  - name: x\n    relation:",
            "EMPTY",
            5,
            "frame_element_grammatical_relations[0].relation",
        ),
        ("- frame_name: a\n  verb: go\n- frame_nam: b\n  verb: come", "UNKNOWN_KEY", 3, "[1].frame_nam"),
        ("frame_name: a\nverb: go\nexamples:\n  - frame_elements: {x: y}", "MISSING_KEY", 4, "examples[0].text"),
    ],
)
def test_bad_file_names_code_line_and_key(text: str, code: str, line: int, key: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_lexical_units(text, "x.yaml")
    problem = refused.value.problems[0]
    assert (problem.code, problem.line, problem.key) == (code, line, key)


@pytest.mark.parametrize(
    "name", ["dobj", "obj", "prep_to", "prep_in_front_of", "obl:to", "nmod:poss", "conj_and", "obl:unmarked", "measure"]
)
def test_relation_name_is_known(name: str) -> None:
    assert is_relation_name(name)


@pytest.mark.parametrize("name", ["dirobj", "prep_", "preposition_to", "Dobj", "", "foo:bar"])
def test_relation_name_is_unknown(name: str) -> None:
    assert not is_relation_name(name)


def test_check_finds_nothing_wrong() -> None:
    assert check_lexical_unit(load_lexical_units(GIVING_2012, "give.yaml")[0], {"giving": GIVING}) == []


@pytest.mark.parametrize(
    "old, new, code",
    [
        ("frame_name: giving", "frame_name: givign", "UNKNOWN_FRAME"),
        ("name: theme", "name: thme", "UNKNOWN_ELEMENT"),
        ("  - name: theme\n    relation: dobj\n", "", "CORE_NOT_FILLED"),
    ],
)
def test_check_names_what_does_not_fit_the_frame(old: str, new: str, code: str) -> None:
    (unit,) = load_lexical_units(GIVING_2012.replace(old, new), "give.yaml")
    assert code in [problem.code for problem in check_lexical_unit(unit, {"giving": GIVING})]


def test_check_names_the_line_of_an_example_with_an_unknown_element() -> None:
    text = GIVING_2012 + "examples:\n  - text: Give me the mug.\n    frame_elements: {recipient: me, thme: the mug}\n"
    (problem,) = check_lexical_unit(load_lexical_units(text, "give.yaml")[0], {"giving": GIVING})
    assert (problem.code, problem.line, problem.key) == ("UNKNOWN_ELEMENT", 9, "examples")
    assert problem.hint == "did you mean 'theme'?"


def test_long_example_is_no_name() -> None:
    words = "and wave " * 50
    (unit,) = load_lexical_units(f"frame_name: waving\nverb: wave\nexamples: [{{text: Wave {words}.}}]\n", "x.yaml")
    assert len(unit.examples[0].text) > 400


CLOSED = load_frame(
    "name: closed\nis_condition: True\nframe_elements: [{name: theme, is_core: True}, {name: state, is_core: True}]",
    "closed.yaml",
)


def test_condition_has_a_state_with_the_words_of_its_elements() -> None:
    text = (
        "frame_name: closed\nholds: {frame: being_located, theme: theme, location: [Its  Place]}\n"
        "values: {state: closed}"
    )
    (unit,) = load_lexical_units(text, "closed.yaml")
    assert unit.holds == (HeldState("being_located", (("theme", "theme"),), (("location", ("its place",)),)),)
    assert unit.values == {"state": "closed"}
    assert check_lexical_unit(unit, {"closed": CLOSED}) == []


def test_element_of_a_state_may_be_some_words_only() -> None:
    text = "frame_name: closed\nholds: {frame: being_in_state, theme: theme, state: {element: state, words: [shut]}}"
    (unit,) = load_lexical_units(text, "closed.yaml")
    assert unit.holds[0].elements == (("theme", "theme"), ("state", "state"))
    assert unit.holds[0].words == (("state", ("shut",)),)
    assert check_lexical_unit(unit, {"closed": CLOSED}) == []


def test_states_with_elements_of_the_same_names_are_listed() -> None:
    (unit,) = load_lexical_units("frame_name: closed\nholds: [being_in_state, existing]", "closed.yaml")
    assert unit.holds == (HeldState("being_in_state"), HeldState("existing"))
    assert check_lexical_unit(unit, {"closed": CLOSED}) == []


def test_event_has_a_subject_that_fills_nothing() -> None:
    text = "frame_name: closed\nevent: fall shut\nsubject: It\nelements: {theme: none}\nvalues: {theme: the door}"
    (unit,) = load_lexical_units(text, "closed.yaml")
    assert (unit.events, unit.subjects) == (("fall shut",), ("it",))


def test_unknown_element_of_a_state_is_refused() -> None:
    with pytest.raises(FileRefused) as refused:
        load_lexical_units("frame_name: closed\nholds: {frame: being_located, them: theme}", "closed.yaml")
    assert [(problem.code, problem.hint) for problem in refused.value.problems] == [
        ("UNKNOWN_KEY", "did you mean 'theme'?")
    ]


@pytest.mark.parametrize(
    "text, code",
    [
        ("frame_name: closed\nverb: close", "NOT_A_COMMAND"),
        ("frame_name: closed\nquestion: is <theme> <state:word>", "NOT_A_COMMAND"),
        ("frame_name: giving\nholds: being_located", "NOT_A_CONDITION"),
        ("frame_name: giving\nevent: give", "NOT_A_CONDITION"),
        ("frame_name: closed\nholds: {frame: being_in_state, theme: theme, state: [shut]}", "CORE_NOT_FILLED"),
        ("frame_name: closed\nholds: {frame: being_in_state, theme: thing}", "UNKNOWN_ELEMENT"),
        ("frame_name: closed\nholds: being_in_state\nvalues: {stat: closed}", "UNKNOWN_ELEMENT"),
    ],
)
def test_condition_is_no_command_and_a_command_no_condition(text: str, code: str) -> None:
    (unit,) = load_lexical_units(text, "x.yaml")
    assert code in [problem.code for problem in check_lexical_unit(unit, {"giving": GIVING, "closed": CLOSED})]
