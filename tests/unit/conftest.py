"""Marks of the tests, and which of them run when nobody names a mark."""

from typing import List

import pytest


def pytest_configure(config: "pytest.Config") -> None:
    config.addinivalue_line("markers", "acceptance: takes minutes; runs with 'pytest -m acceptance' only")


def pytest_collection_modifyitems(config: "pytest.Config", items: "List[pytest.Item]") -> None:
    if config.option.markexpr:
        return
    for item in items:
        if item.get_closest_marker("acceptance"):
            item.add_marker(pytest.mark.skip(reason="takes minutes: pytest -m acceptance"))
