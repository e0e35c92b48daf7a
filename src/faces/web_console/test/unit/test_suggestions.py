"""Sentences that can be said here and now."""

from web_console.suggestions import Present, Template, read_templates, suggest

GO = Template("navigating_to_location", "Go to the {room}.")
BRING = Template("bringing", "Bring me the {thing}.")
PUT = Template("placing", "Put the {thing} on the {surface}.")
SWITCH = Template("switching_device", "Switch on the {off}.")
PING = Template("pinging", "Ping.")
ALL = (GO, BRING, PUT, SWITCH, PING)
FRAMES = frozenset(one.frame for one in ALL)
HOME = (
    Present("kitchen", "place", is_wide=True),
    Present("hall", "place", is_wide=True),
    Present("dock", "place"),
    Present("desk", "thing", is_wide=True, carries=True),
    Present("wardrobe", "thing", frozenset(("closed",)), is_wide=True),
    Present("red mug", "thing", is_loose=True),
    Present("box", "thing"),
    Present("radio", "device", frozenset(("off",)), is_wide=True),
)


def test_sentences_are_of_what_is_here():
    assert suggest(ALL, FRAMES, HOME, ()) == (
        "Go to the hall.",
        "Bring me the red mug.",
        "Put the red mug on the desk.",
        "Switch on the radio.",
        "Ping.",
        "Go to the kitchen.",
    )


def test_without_a_server_or_an_object_nothing_is_suggested():
    assert suggest(ALL, frozenset(("pinging",)), HOME, ()) == ("Ping.",)
    assert suggest(ALL, FRAMES, (), ()) == ("Ping.",)


def test_what_is_not_sure_is_not_suggested():
    twice = (Present("light", "device", frozenset(("off",))), Present("light", "device", frozenset(("on",))))
    before = (Present("keys", "thing", is_loose=True, is_before=True),)
    assert suggest((SWITCH, BRING), FRAMES, (*twice, *before), ()) == ()


def test_what_was_said_comes_again_when_all_was_said():
    assert suggest((GO,), FRAMES, HOME, ("go to the hall",)) == ("Go to the kitchen.",)
    assert len(suggest((GO,), FRAMES, HOME, ("go to the hall", "Go to the kitchen."))) == 2


def test_kinds_take_turns():
    said = ("Go to the hall.", "Switch on the lamp.")
    assert suggest((GO, SWITCH, PING), FRAMES, HOME, said) == ("Ping.", "Go to the kitchen.", "Switch on the radio.")


def test_full_hands_take_nothing_more():
    held = (*HOME, Present("blue mug", "thing", holder="robot"))
    bring, put_down = (
        Template("bringing", "Bring me the {thing}.", "taker"),
        Template("placing", "Put the {held} on the {surface}."),
    )
    take = Template("placing", "Put the {thing} on the {surface}.", "hand")
    assert suggest((bring, take, put_down), FRAMES, held, ()) == ("Put the blue mug on the desk.",)
    given = (*HOME, Present("blue mug", "thing", holder="person"))
    assert suggest((bring, take), FRAMES, given, ()) == ("Put the red mug on the desk.",)


def test_verb_agrees():
    ask = Template("question_of_place", "Where {is} the {thing}?")
    asked = suggest((ask,), frozenset((ask.frame,)), (*HOME, Present("keys", "thing", is_loose=True)), ())
    assert asked == ("Where are the keys?", "Where is the red mug?")


def test_every_template_has_a_known_slot():
    every = tuple(
        Present(f"{sort} {state} {wide} {loose}", sort, frozenset((state,)), wide, loose, carries=wide)
        for sort in ("place", "person", "door", "device", "thing")
        for state in ("open", "closed", "on", "off", "")
        for wide in (True, False)
        for loose in (True, False)
    )
    held = (*every, Present("mug", "thing", holder="robot"))
    for one in read_templates():
        assert suggest((one,), frozenset((one.frame,)), held if "{held}" in one.say else every, ()), one.say
