/* What the example needs of the chip: semihosting for output, SysTick, sleep. */
#ifndef CHIP_H
#define CHIP_H
#include <stdint.h>

void print(const char *text);
void print_number(uint32_t number);
void print_bits_f32(float number);
void print_bits_f64(double number);
void leave(uint32_t code);
void start_systick(uint32_t cycles);
void wait_for_interrupt(void);
#endif
