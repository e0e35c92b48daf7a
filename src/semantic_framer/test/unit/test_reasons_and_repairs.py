"""Reasons before a command, descriptions of persons, and what people say again with more precision."""

from typing import Any

import pytest

from semantic_framer.framer import Policy, Question, Refusal, Understood


def said(outcome: Any) -> str:
    """Return the frames with what was said for their elements."""
    assert isinstance(outcome, Understood), outcome
    return " + ".join(
        f"{readings[0].unit.frame_name}("
        + ", ".join(f"{one.name}={one.text}" for one in readings[0].arguments if one.positions)
        + ")"
        for readings in outcome.clauses
    )


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        # Where a person is described to another one.
        (
            "Describe the person lying down at the exit to the person at the dishwasher.",
            "describing(item=the person lying down at the exit, addressee=the person at the dishwasher)",
        ),
        ("Greet the person dressed in a red coat.", "greeting(addressee=the person dressed in a red coat)"),
        (
            "Offer something to eat to all the women in the living room.",
            "offering(theme=something to eat, recipient=all the women in the living room)",
        ),
        ("Bring Anna in the kitchen a glass.", "bringing(theme=a glass, beneficiary=Anna in the kitchen)"),
        ("Bring me please a glass of water.", "bringing(theme=a glass of water, beneficiary=me)"),
        # Nobody is spoken to without a pause.
        ("Spot Ali, escort him to the exit.", "locating(sought_entity=Ali) + guiding(cotheme=Ali, goal=the exit)"),
        (
            "Pinpoint Hayden in the hall, spot Alex, and wave.",
            "locating(sought_entity=Hayden, ground=the hall) + locating(sought_entity=Alex) + waving()",
        ),
        (
            "Take the peach from the counter, and look for Adam at the chair.",
            "taking(theme=the peach, source=the counter) + locating(sought_entity=Adam, ground=the chair)",
        ),
        # A reason forbids nothing.
        ("The dog needs to go out, open the back door.", "opening(container_portal=the back door)"),
        ("I'm not feeling well, bring me some water.", "bringing(theme=some water, beneficiary=me)"),
        ("the window is not closed, close it", "closing(container_portal=the window)"),
        ("Bring me water I'm thirsty.", "bringing(theme=water, beneficiary=me)"),
        ("Can you carry my bag it's so heavy?", "bringing(theme=my bag, agent=you)"),
        # Not everything is wanted, and somebody else shall not do something.
        ("Wipe the table but not the chairs.", "wiping(object=the table)"),
        (
            "Ask the lady with the hat not to touch the painting.",
            "requesting(addressee=the lady with the hat, message=not to touch the painting)",
        ),
        # Pronouns stand for what has the type of the element.
        (
            "Put the sample into the centrifuge and start it.",
            "placing(theme=the sample, goal=the centrifuge) + switching_device(device=the centrifuge)",
        ),
        (
            "Take radio 7 from the charger and switch it on.",
            "taking(theme=radio 7, source=the charger) + switching_device(device=radio 7, operational_state=on)",
        ),
        (
            "Greet the group and lead them to the cafe.",
            "greeting(addressee=the group) + guiding(cotheme=them, goal=the cafe)",
        ),
        ("Give the children some paper and pencils.", "giving(theme=some paper and pencils, recipient=the children)"),
        ("Bring the first aid kit to the reception.", "bringing(theme=the first aid kit, goal=the reception)"),
        # Words that the tagger takes for verbs.
        ("Give grandpa his glasses.", "giving(theme=his glasses, recipient=grandpa)"),
        ("Bring the watering can to the greenhouse.", "bringing(theme=the watering can, goal=the greenhouse)"),
        ("Make the coffee.", "cooking(food=the coffee)"),
        (
            "Put the green cup left of the plate and the spoon right of it.",
            "placing(theme=the green cup, goal=the left of the plate) + placing(theme=the spoon, goal=the right of it)",
        ),
        ("I need you bring me the chair.", "bringing(theme=the chair, beneficiary=me)"),
        # Said again.
        (
            "Turn to your left turn forty five degrees to your left.",
            "turning(direction=left, angle=45, angle_unit=degrees)",
        ),
        ("Bring me three apples, actually make that four.", "bringing(theme=4 apples, beneficiary=me)"),
        ("Bring me the blue, uh, the green mug.", "bringing(theme=the green mug, beneficiary=me)"),
        (
            "Bring two beers, one for me and one for Dave.",
            "bringing(theme=one beer, beneficiary=me) + bringing(theme=one beer, beneficiary=Dave)",
        ),
        (
            "Lead the woman dressed in a blue blouse in the corridor to the living room.",
            "guiding(cotheme=the woman dressed in a blue blouse in the corridor, goal=the living room)",
        ),
        (
            "Bring the bag to the person dressed in an orange coat.",
            "bringing(theme=the bag, beneficiary=the person dressed in an orange coat)",
        ),
        ("Lead the group to the skeleton.", "guiding(cotheme=the group, goal=the skeleton)"),
        ("Fetch the supplies from the closet.", "fetching(theme=the supplies, source=the closet)"),
        # A setting is no place.
        ("Set the gripper to 50 percent.", "switching_device(device=the gripper, operational_state=50 percent)"),
        ("Make the lights brighter in the kitchen.", "brightening(item=the lights in the kitchen)"),
        ("Bring everything except the knives.", "bringing(theme=everything except the knives)"),
        # Openings of people who learn English, and of polite ones.
        ("I want that you go to the kitchen.", "navigating_to_location(goal=the kitchen)"),
        ("Bring me a screwdriver asap.", "bringing(theme=a screwdriver, beneficiary=me)"),
        # A thing and "please".
        ("Coffee please.", "bringing(theme=coffee)"),
        ("Two napkins, please.", "bringing(theme=two napkins)"),
    ],
)
def test_what_is_meant(understand: Any, text: str, meant: str) -> None:
    assert said(understand(text)[0]) == meant


@pytest.mark.parametrize(
    "text",
    [
        # What is forbidden stays forbidden.
        "You can't go to the kitchen, go to the hall.",
        "Don't go to the kitchen and go to the hall.",
        # What is left is no place that the robot is in.
        "Leave the heavy ones.",
        # Nobody brings these.
        "Lights please.",
        "The door please.",
        "A room please.",
        # A number before a preposition is no part of the place.
        "Continue three hundred to si.",
    ],
)
def test_nothing_is_done(understand: Any, text: str) -> None:
    assert isinstance(understand(text)[0], (Refusal, Question))


@pytest.mark.parametrize("text", ["Turn on the oven.", "Go to the oven and turn it on."])
def test_what_a_pronoun_stands_for_wants_a_yes(understand: Any, text: str) -> None:
    outcome, _ = understand(text, policy=Policy())
    assert isinstance(outcome, Question) and outcome.code == "CONFIRM"


def test_couple_is_two(understand: Any) -> None:
    outcome, _ = understand("Bring a couple of beers.")
    assert outcome.clauses[0][0].argument("theme").count == 2
