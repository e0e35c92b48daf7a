"""The mood matrix: each verb that a shipped server carries out, in 24 constructions, with the right answer."""
