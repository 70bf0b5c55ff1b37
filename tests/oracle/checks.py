"""Counted checks: a part that checked nothing has failed."""


class Checks:
    def __init__(self, title, show=5):
        self.title, self.show, self.count, self.failures = title, show, 0, []

    def true(self, what, holds):
        self.count += 1
        if not holds:
            self.failures.append(what)
        return holds

    def equal(self, what, got, want):
        self.count += 1
        if got != want:
            self.failures.append(f"{what}: {got} where {want} is right")

    def finish(self):
        """Prints the result; True if all held."""
        print(f"{self.title}: {self.count} checks, {len(self.failures)} failures")
        for failure in self.failures[: self.show]:
            print(f"  {failure}")
        if self.count == 0:
            print("  nothing was checked")
        return self.count > 0 and not self.failures


def run_parts(parts, chosen, *subject):
    """Runs the parts (functions `check_<name>`) that were chosen, or all; True if all held."""
    held = True
    for name, part in parts.items():
        if not chosen or name in chosen:
            checks = Checks(name)
            part(*subject, checks)
            held &= checks.finish()
    return held


def by_name(*parts):
    return {part.__name__.removeprefix("check_"): part for part in parts}
