"""What the course costs: `uv run python -m tests.bench [NAME ...] [--json]`. Figures only: nothing here fails."""
