"""Questions about random states of a home, with answers that are judged by the home itself."""
