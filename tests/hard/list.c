/* list.c - see list.h
 * SPDX-License-Identifier: Apache-2.0
 */
#include "list.h"

#include <stdlib.h>

#include "named.h"

void hard_list_add(struct hard_list *list, struct hard_item item) {
    if (list->n == list->room) {
        size_t room = list->room ? 2 * list->room : 1024;
        struct hard_item *items = realloc(list->items, room * sizeof *items);
        if (!items) {
            perror("hard_list_add");
            exit(2);
        }
        list->items = items;
        list->room = room;
    }
    item.named = list->named;
    list->items[list->n++] = item;
}

struct hard_list hard_list_named(int profile) {
    struct hard_list list = {0};
    for (int i = 0; i < hard_n_named; i++) {
        struct named n = hard_named_start(profile);
        n.list = &list;
        list.named = i + 1;
        hard_named[i].run(&n);
    }
    return list;
}

const char *hard_named_name(int number) {
    return hard_named[number - 1].name;
}
