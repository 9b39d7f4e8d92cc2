/**
 * @file
 * As much of FreeRTOS as the example Tasks uses, written after its interface, for this machine: queues that never wait, and tasks that a test
 * carries out by hand. It is not FreeRTOS, and has no scheduler.
 */
#ifndef FREERTOS_STUB_H
#define FREERTOS_STUB_H

#include <stdint.h>
#include <string.h>

#include <deque>
#include <vector>

typedef int BaseType_t;
typedef unsigned UBaseType_t;
typedef uint32_t TickType_t;
typedef void (*TaskFunction_t)(void *);
typedef void *TaskHandle_t;

#define pdTRUE 1
#define pdFALSE 0
#define pdPASS pdTRUE
#define pdMS_TO_TICKS(ms) static_cast<TickType_t>(ms)

struct StubQueue {
  size_t length;
  size_t size;
  std::deque<std::vector<uint8_t>> items;
};
typedef StubQueue *QueueHandle_t;

inline QueueHandle_t xQueueCreate(UBaseType_t length, UBaseType_t size) { return new StubQueue{length, size, {}}; }

inline BaseType_t xQueuePeek(QueueHandle_t queue, void *item, TickType_t) {
  if (queue->items.empty())
    return pdFALSE;
  memcpy(item, queue->items.front().data(), queue->size);
  return pdTRUE;
}

inline BaseType_t xQueueReceive(QueueHandle_t queue, void *item, TickType_t ticks) {
  BaseType_t found = xQueuePeek(queue, item, ticks);
  if (found)
    queue->items.pop_front();
  return found;
}

/** For queues of one item. */
inline BaseType_t xQueueOverwrite(QueueHandle_t queue, const void *item) {
  const uint8_t *bytes = static_cast<const uint8_t *>(item);
  queue->items.assign(1, std::vector<uint8_t>(bytes, bytes + queue->size));
  return pdPASS;
}

extern std::vector<TaskFunction_t> stub_tasks;

inline BaseType_t xTaskCreatePinnedToCore(TaskFunction_t task, const char *, uint32_t, void *, UBaseType_t, TaskHandle_t *, BaseType_t) {
  stub_tasks.push_back(task);
  return pdPASS;
}
inline TickType_t xTaskGetTickCount() { return 0; }
inline void vTaskDelay(TickType_t) {}
inline void vTaskDelayUntil(TickType_t *, TickType_t) {}
inline void vTaskDelete(TaskHandle_t) {}

#endif
