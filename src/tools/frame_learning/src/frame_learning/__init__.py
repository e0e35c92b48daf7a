"""Lexical units learned from annotated sentences, and figures on annotated corpora."""
