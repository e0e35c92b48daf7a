"""What stands behind a cry: a command of its own, or none."""

import pytest

from command_server.command_behind import command_behind
from command_server.stop_words import find_cry


@pytest.mark.parametrize(
    "text, command",
    [
        ("Stop and come back.", "come back."),
        ("stop and come back", "come back"),
        ("STOP AND COME BACK", "COME BACK"),
        ("stop then go to the kitchen", "go to the kitchen"),
        ("Stop, then go to the kitchen.", "go to the kitchen."),
        ("stop and then turn left", "turn left"),
        ("Stop, turn left.", "turn left."),
        ("Stop! Turn left!", "Turn left!"),
        ("Stop. Turn left 90 degrees.", "Turn left 90 degrees."),
        ("Stop stop stop! Turn left.", "Turn left."),
        ("robot please stop and turn around", "turn around"),
        ("stop right now and turn around", "turn around"),
        ("stop please and turn around please", "turn around please"),
        ("stop moving and come back", "come back"),
        ("stop following me and go to the kitchen", "go to the kitchen"),
        ("stop following Anna and Bob and go to the kitchen", "go to the kitchen"),
        ("stop the music and turn on the light", "turn on the light"),
        ("stop moving and vacuum the floor", "vacuum the floor"),
        ("stop and water the plants", "water the plants"),
        ("Stop, please come back", "come back"),
        ("Stop, can you come back?", "come back?"),
        ("stop and can you come back", "can you come back"),
        ("halt and go back", "go back"),
        ("Wait, turn left.", "turn left."),
        ("hold on and go back", "go back"),
        ("Cancel that, go home.", "go home."),
        ("cancel and come back", "come back"),
        ("forget it, come back", "come back"),
        ("never mind, go to the office", "go to the office"),
        ("no no no stop, go back", "go back"),
        ("you will hit the lamp, stop and go back", "go back"),
        ("Stop \u2013 turn left", "turn left"),
        ("no wait, right", "right"),
        ("stop, left please", "left please"),
        ("stop and bring me the cup", "bring me the cup"),
        ('stop and say "you are here"', 'say "you are here"'),
        ("stop and go to the door and stop there", "go to the door and stop there"),
        ("stop and stop at the door", "stop at the door"),
        ("No, wait, I meant the plate.", "I meant the plate."),
        ("Stop, I mean the red one", "I mean the red one"),
    ],
)
def test_command_behind_a_cry(text, command):
    assert command_behind(find_cry(text).rest) == command


@pytest.mark.parametrize(
    "text",
    [
        "stop",
        "Stop!",
        "Stop. Stop. Stop.",
        "stop, you will hit the lamp",
        "stop you will hit the lamp",
        "Stop! You will turn over.",
        "stop and you will be fine",
        "stop and wait",
        "stop and stay there",
        "stop and don't move",
        "stop, don't move",
        "stop and stop",
        "Stop, stop, stop!",
        "stop there is a child",
        "stop, there is a child",
        "stop, the lamp",
        "stop the music and the lights",
        "stop talking and laughing",
        "stop following me and Anna",
        "stop or turn left",
        "stop or I will turn you off",
        "stop because you turn left",
        "stop until I say go and then turn left",
        "stop before you hit the wall and turn over",
        "stop, I go first",
        "Stop! Watch the vase!",
        "stop, careful",
        "stop, look out",
        "stop, that is the wrong way",
        "stop and",
        "stop then",
        "stop, please",
        "stop, thank you",
        "stop, robot",
        "stop it now",
        "stop going to the kitchen",
        "stop go back",
        "stop turn left",
        "stop! Turn left! Stop!",
        "stop and turn left no stop",
        "stop follow me",
        "stop, if you turn left we are lost",
        "stop so that Anna and Bob can go",
        "wait, you turn left",
        "Stop, I mean it!",
        "Stop, I mean stop.",
        "Wait, I mean, stop.",
        "Stop, I meant what I said.",
        "Stop. I meant.",
    ],
)
def test_no_command_behind_a_cry(text):
    assert command_behind(find_cry(text).rest) == ""


def test_any_length():
    assert command_behind(" and" * 1000) == ""
    assert command_behind(" and ," * 500 + "turn left") == "turn left"
