/* Start of a Cortex-M4F without any library, and semihosting. */
#include "chip.h"

int main(void);
void SysTick_Handler(void);
void Reset_Handler(void);

extern uint32_t stack_top, data_begin, data_end, data_in_flash, bss_begin, bss_end;

static void fault(void) { leave(101); }

/* Initial stack pointer, reset, the fourteen other exceptions. */
__attribute__((section(".vectors"), used)) static const union {
    void (*handler)(void);
    const void *address;
} vectors[16] = {
    {.address = &stack_top}, {Reset_Handler}, {fault}, {fault}, {fault}, {fault}, {fault}, {0},
    {0}, {0}, {0}, {fault}, {fault}, {0}, {fault}, {SysTick_Handler},
};

void Reset_Handler(void) {
    volatile uint32_t *access = (volatile uint32_t *)0xe000ed88u; /* CPACR: the floating-point unit */
    *access |= 0xf00000u;
    __asm__ volatile("dsb\nisb");
    for (uint32_t *to = &data_begin, *from = &data_in_flash; to < &data_end; to++, from++) *to = *from;
    for (volatile uint32_t *to = &bss_begin; to < &bss_end; to++) *to = 0;
    leave((uint32_t)main());
}

static uint32_t semihosting(uint32_t operation, const void *argument) {
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void print(const char *text) { semihosting(0x04, text); }

void print_number(uint32_t number) {
    char text[11], *at = text + 10;
    *at = 0;
    do {
        *--at = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    print(at);
}

static void print_hexadecimal(uint64_t bits, int digits) {
    char text[18] = {' '};
    text[digits + 1] = 0;
    for (int i = digits; i > 0; i--, bits >>= 4) text[i] = "0123456789abcdef"[bits & 15];
    print(text);
}

void print_bits_f32(float number) {
    union { float number; uint32_t bits; } both = {number};
    print_hexadecimal(both.bits, 8);
}

void print_bits_f64(double number) {
    union { double number; uint64_t bits; } both = {number};
    print_hexadecimal(both.bits, 16);
}

void leave(uint32_t code) {
    uint32_t words[2] = {0x20026u, code};
    semihosting(0x20, words);
    for (;;) {}
}

void start_systick(uint32_t cycles) {
    volatile uint32_t *systick = (volatile uint32_t *)0xe000e010u;
    systick[1] = cycles - 1;
    systick[2] = 0;
    systick[0] = 7;
}

void wait_for_interrupt(void) { __asm__ volatile("wfi"); }
