/* uio.c - a frame of rt_top from user space of Linux, by its driver for UIO (uio_pdrv_genirq)
 * SPDX-License-Identifier: Apache-2.0
 *
 *     cc -std=c99 -Idriver examples/linux/uio.c driver/sphaera.c -o draw
 *     draw /dev/uio0 machine.sph >frame.ppm
 *
 * The node in the device tree (sphaera,rt-top.yaml, rt-top.dtsi) has two ranges: map0 registers,
 * map1 memory that is reserved for scene and frames. UIO maps both as devices, without caches, so
 * of the contract of struct sphaera_bus barriers alone are left. The caller of a driver that maps
 * memory with caches has to clean and invalidate them, too.
 */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <fcntl.h>
#include <inttypes.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sphaera.h"
#include "sphaera_file.h"

enum { SECONDS = 60, POLLS = 1000000, FRAMES_AT = 0x1000000, ALIGN = 4096 };

struct device {
    volatile uint32_t *registers;
    uint8_t *memory;
    uint64_t address, size; /* of memory, as the block and the device tree have it */
};

static uint32_t get(void *user, uint32_t offset) {
    const struct device *d = user;
    uint32_t value = d->registers[offset / 4];
    __sync_synchronize(); /* what is read behind it is not read before */
    return value;
}

static void set(void *user, uint32_t offset, uint32_t value) {
    const struct device *d = user;
    __sync_synchronize(); /* what was put is there before the block is told */
    d->registers[offset / 4] = value;
}

static void put(void *user, uint64_t address, const uint8_t *bytes, uint32_t count) {
    const struct device *d = user;
    memcpy(d->memory + (address - d->address), bytes, count);
    __sync_synchronize();
}

static int failed(const char *what, const char *why) {
    fprintf(stderr, "uio: %s: %s\n", what, why);
    return 1;
}

/* A number of /sys/class/uio/NAME/maps/map1; 0 if there is none. */
static uint64_t attribute(const char *device, const char *name) {
    char path[256];
    const char *base = strrchr(device, '/');
    snprintf(path, sizeof path, "/sys/class/uio/%s/maps/map1/%s", base ? base + 1 : device, name);
    FILE *f = fopen(path, "r");
    if (!f) return 0;
    uint64_t value = 0;
    if (getc(f) == '0' && getc(f) == 'x') /* so UIO writes them */
        for (int c; isxdigit(c = getc(f));)
            value = 16 * value + (uint64_t)(isdigit(c) ? c - '0' : tolower(c) - 'a' + 10);
    fclose(f);
    return value;
}

static int map(struct device *d, const char *name, int fd) {
    const size_t page = (size_t)sysconf(_SC_PAGESIZE); /* map n is at page n of the file */
    d->address = attribute(name, "addr");
    d->size = attribute(name, "size");
    if (!d->size) return failed(name, "has no map1: reserved memory in the device tree");
    void *registers = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    void *memory = mmap(NULL, (size_t)d->size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, (off_t)page);
    if (registers == MAP_FAILED || memory == MAP_FAILED) return failed(name, "cannot be mapped");
    d->registers = registers;
    d->memory = memory;
    return 0;
}

static uint8_t *whole(const char *path, uint32_t *bytes) {
    FILE *f = fopen(path, "rb");
    struct stat s;
    if (!f) return NULL;
    uint8_t *data = NULL;
    if (!fstat(fileno(f), &s) && s.st_size > 0 && s.st_size <= (off_t)UINT32_MAX)
        data = malloc((size_t)s.st_size);
    if (data && fread(data, 1, (size_t)s.st_size, f) != (size_t)s.st_size) {
        free(data);
        data = NULL;
    }
    fclose(f);
    *bytes = data ? (uint32_t)s.st_size : 0;
    return data;
}

/* Waits for the interrupt, which UIO counts; it is enabled again by a word that is written. */
static int wait_for_frame(struct sphaera *s, int fd) {
    struct pollfd interrupt = {.fd = fd, .events = POLLIN};
    uint32_t count = 1;
    if (write(fd, &count, sizeof count) != (ssize_t)sizeof count) return SPHAERA_LATE;
    if (poll(&interrupt, 1, SECONDS * 1000) != 1) return SPHAERA_LATE;
    if (read(fd, &count, sizeof count) != (ssize_t)sizeof count) return SPHAERA_LATE;
    sphaera_handle(s);
    return sphaera_wait(s, POLLS);
}

static void print(const struct device *d, uint64_t frame, uint32_t w, uint32_t h, uint32_t stride) {
    printf("P6\n%" PRIu32 " %" PRIu32 "\n255\n", w, h);
    for (uint32_t y = 0; y < h; y++)
        for (uint32_t x = 0; x < w; x++) {
            uint32_t pixel;
            memcpy(&pixel, d->memory + (frame - d->address) + y * stride + 4 * x, 4);
            putchar((int)(pixel >> 16 & 255));
            putchar((int)(pixel >> 8 & 255));
            putchar((int)(pixel & 255));
        }
}

static int draw(struct device *d, int fd, const uint8_t *file, uint32_t bytes) {
    const struct sphaera_bus bus = {get, set, put, d};
    struct sphaera s;
    struct sphaera_file f;
    if (!sphaera_file_read(&f, file, bytes))
        return failed("machine", sphaera_text(SPHAERA_BAD_FILE));
    const uint32_t w = sphaera_file_register(&f, SPHAERA_REG_FRAME_W);
    const uint32_t h = sphaera_file_register(&f, SPHAERA_REG_FRAME_H);
    const uint32_t stride = (4 * w + 31) / 32 * 32;
    const uint64_t frame = ((uint64_t)stride * h + ALIGN - 1) / ALIGN * ALIGN;
    uint64_t frames[3];
    for (unsigned i = 0; i < 3; i++)
        frames[i] = d->address + FRAMES_AT + i * frame;
    if (f.memory_bytes > FRAMES_AT || FRAMES_AT + 3 * frame > d->size)
        return failed("machine", "scene and frames do not fit into the reserved memory");
    int rc = sphaera_open(&s, &bus);
    if (!rc) rc = sphaera_load(&s, file, bytes, d->address);
    if (!rc) rc = sphaera_store(&s, frames, stride, 0);
    if (!rc) sphaera_interrupts(&s, SPHAERA_INTERRUPTS_FRAME_DONE);
    if (!rc) rc = sphaera_start(&s, 0);
    if (!rc) rc = wait_for_frame(&s, fd);
    unsigned newest = 0;
    if (!rc) rc = sphaera_take(&s, &newest);
    if (rc) return failed("rt_top", sphaera_text(rc));
    print(d, frames[newest], w, h, stride);
    return fflush(stdout) || ferror(stdout) ? failed("standard output", "cannot be written") : 0;
}

int main(int argc, char **argv) {
    if (argc != 3) {
        fprintf(stderr, "usage: uio /dev/uioN MACHINE.sph >FRAME.ppm\n");
        return 2;
    }
    struct device d;
    uint32_t bytes;
    uint8_t *file = whole(argv[2], &bytes);
    if (!file) return failed(argv[2], "cannot be read");
    const int fd = open(argv[1], O_RDWR);
    int rc = fd < 0 ? failed(argv[1], "cannot be opened") : map(&d, argv[1], fd);
    if (!rc) rc = draw(&d, fd, file, bytes);
    free(file);
    return rc;
}
