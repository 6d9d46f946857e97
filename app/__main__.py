"""The command line; it imports only the chosen job."""


def main() -> int:
    return 0
