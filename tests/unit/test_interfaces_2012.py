"""The messages of 2012 keep their fields: each has its published MD5 sum."""

import importlib

import pytest

CHECKSUMS = [
    ("roboframenet_msgs.msg", "EmptyFrameElement", "a29b0317b8ca9f43f3140ecb78df89fc"),
    ("roboframenet_msgs.msg", "EmptySemanticFrame", "7e363b67e656a5799fe51a2012c51f8a"),
    ("roboframenet_msgs.msg", "FilledFrameElement", "e57a85352b22994f46cb6d7ccbb64da8"),
    ("roboframenet_msgs.msg", "FilledLexicalUnit", "6a8cb181df1bc63b3988099eee52c247"),
    ("roboframenet_msgs.msg", "FilledLexicalUnitList", "ef58cd811a0a319433ad38d92b17ad4a"),
    ("roboframenet_msgs.msg", "FilledSemanticFrame", "af2ebb4070173b2d608a60ad2d4bb7d7"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameList", "aac6e5d851941e02a5198adc12df4969"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameListList", "737111e9f6697d31eca2c3093b6a96ef"),
    ("roboframenet_msgs.msg", "Procedure", "737111e9f6697d31eca2c3093b6a96ef"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameGoal", "a6589ab534cf6440192eaa954de43f00"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameResult", "358e233cde0c8a8bcfea4ce193f8fc15"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameFeedback", "a10cc2c03636e881dbc09671ae16c76f"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameActionGoal", "65caa87abbeb0410eeb158b7bae4b172"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameActionResult", "0698ce25b2d595b82357c010557e935f"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameActionFeedback", "3030aaee450122af6384de8a27865d9b"),
    ("roboframenet_msgs.msg", "FilledSemanticFrameAction", "155f2082a80e8d33020a74c63f2ac0f6"),
    ("roboframenet_msgs.srv", "AddFrameRequest", "35069f362a779b7b03577249e8767ce3"),
    ("roboframenet_msgs.srv", "AddLexicalUnitRequest", "35069f362a779b7b03577249e8767ce3"),
    ("roboframenet_msgs.srv", "GetEmptyFrameRequest", "6e7eaaf88672eee626ddd9494bce2298"),
    ("roboframenet_msgs.srv", "RegisterWithFrameRequest", "0d6d3e4a7ab16fd0b073948a00b7b9d3"),
    ("roboframenet_msgs.srv", "AddFrame", "cb6a241b274ea486767393c609cdf1cb"),
    ("roboframenet_msgs.srv", "AddLexicalUnit", "cb6a241b274ea486767393c609cdf1cb"),
    ("roboframenet_msgs.srv", "GetEmptyFrame", "04219de4717ce8422705fc0a0c034202"),
    ("roboframenet_msgs.srv", "RegisterWithFrame", "d8348aca95ebc2a23cee1717f1fa3def"),
    ("stanford_parser_msgs.msg", "Dependency", "cdc828bde2cbc087845b7c347e45a5ee"),
    ("stanford_parser_msgs.msg", "SquashedParseTreeNode", "8e3f507a30ff03f4eed132c8e51d902b"),
    ("stanford_parser_msgs.msg", "Parse", "094e3dbdff171c4bff80579d73b3ed1b"),
    ("location_memorizer.srv", "GetLocationRequest", "c1f3d28f1b044c871e6eff2e9fc3c667"),
    ("location_memorizer.srv", "GetLocation", "063bc9ef3579ffcc1f68f8803767c82b"),
]


@pytest.mark.parametrize("module, name, checksum", CHECKSUMS)
def test_checksum_is_the_one_of_2012(module: str, name: str, checksum: str) -> None:
    assert getattr(importlib.import_module(module), name)._md5sum == checksum


def test_tags_of_the_phrase_tree_are_numbered_without_gaps() -> None:
    node = importlib.import_module("stanford_parser_msgs.msg").SquashedParseTreeNode
    tags = sorted(value for key, value in vars(node).items() if key.isupper() and isinstance(value, int))
    assert tags == list(range(-182, -99))
