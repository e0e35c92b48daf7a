"""What the robot can do, from files and servers."""

from web_console.abilities import Knowledge

PARTY = """
name: party
frame_elements: [{name: guest, is_core: True}]
children:
  - - name: raising
      frame_element_relations: [{parent_name: guest, child_name: arm}]
    - name: waving
      frame_element_relations: [{parent_name: guest, child_name: addressee}]
"""
WAVING = "name: waving\ndescription: The robot\n  waves.\nframe_elements: [{name: addressee, is_core: True}]"
FRAMES = (
    ("/x/greeting/frames/waving.yaml", WAVING),
    ("/x/greeting/frames/raising.yaml", "name: raising\nframe_elements: [{name: arm, is_core: True}]"),
    ("/x/show/frames/party.yaml", PARTY),
    ("/x/bad/frames/bad.yaml", "name: [unclosed"),
)
UNIT = """
frame_name: {frame}
verb: {verb}
frame_element_grammatical_relations: [{{name: {element}, relation: dobj}}]
examples:
  - {{text: "{title} Alice.", frame_elements: {{{element}: Alice}}}}
  - {{text: {verb} him, frame_elements: {{{element}: him}}}}
"""
UNITS = (
    *(
        (f"/x/units/{frame}.yaml", UNIT.format(frame=frame, verb=verb, title=verb.title(), element=element))
        for frame, verb, element in (
            ("waving", "wave", "addressee"),
            ("raising", "raise", "arm"),
            ("party", "welcome", "guest"),
        )
    ),
    ("/x/units/bad.yaml", "verb: 3"),
)


def view(servers, names=()):
    return Knowledge().view(FRAMES, UNITS, servers, names)


def test_frames_with_a_server_can_be_done():
    found = view({"waving": ("left_arm", "right_arm")})
    assert [one.frame for one in found.abilities] == ["waving"]
    waving = found.abilities[0]
    assert waving.servers == ("left_arm", "right_arm")
    assert (waving.domain, waving.description) == ("greeting", "The robot waves.")
    assert waving.examples == ("Wave Alice.", "Wave him")


def test_frames_whose_children_have_servers_can_be_done():
    assert [one.frame for one in view({"waving": ("a",), "raising": ("b",)}).abilities] == [
        "raising",
        "waving",
        "party",
    ]


def test_without_servers_nothing_can_be_done():
    found = view({})
    assert found.abilities == () and found.words == ()
    assert (found.frames, found.units) == (3, 3)


def test_words_are_those_of_what_can_be_done_and_of_places():
    words = view({"waving": ("a",)}, names=("kitchen",)).words
    assert {"wave", "alice", "kitchen"} <= set(words)
    assert "raise" not in words


def test_broken_files_are_left_to_the_framer_and_the_registrar():
    assert view({"bad": ("a",)}).abilities == ()
