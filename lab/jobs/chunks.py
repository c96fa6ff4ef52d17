# chunks.py - jobs put together into chunks that are worth a place in a queue
# SPDX-License-Identifier: Apache-2.0
LEAST, MOST = 30.0, 60.0  # seconds of a chunk


def cut(jobs, least=LEAST, most=MOST):
    """Lists of jobs, together all of them. Each costs `least` to `most`, but for one that may cost
    less, and for a job that by itself costs more. Jobs keep their order as far as that allows."""
    done, open_ones = [], []
    for job in jobs:
        cost = max(float(job["cost"]), 0)
        room = next((c for c in open_ones if c[0] + cost <= most), None)
        if room is None:
            room = [0.0, []]
            done.append(room)
            open_ones.append(room)
        room[0] += cost
        room[1].append(job)
        if room[0] >= least:
            open_ones.remove(room)
    return [c[1] for c in done]
