# sphaera_coverage.py - what a run of an agent has met
# SPDX-License-Identifier: Apache-2.0
from collections import Counter


class Coverage:
    """Bins that must be met, and how often each was."""

    def __init__(self, bins):
        self.bins = Counter({name: 0 for name in bins})

    def sample(self, name, met=True):
        """Counts a bin. KeyError: there is none of this name."""
        if name not in self.bins:
            raise KeyError(name)
        self.bins[name] += bool(met)

    @property
    def missing(self):
        """Bins that were not met."""
        return [name for name, n in self.bins.items() if not n]

    def __str__(self):
        met = len(self.bins) - len(self.missing)
        lines = [f"coverage: {met} of {len(self.bins)} bins"]
        return "\n".join(lines + [f"  {name:24} {n}" for name, n in self.bins.items()])
