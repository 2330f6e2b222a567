/* Barriers that round a product to its type, so that no compiler fuses it with a sum, in any standard and with any flags. */
#if defined(__GNUC__) && defined(__SSE2__)
#define TOYTOP_BARRIER_float(x) __asm__("" : "+x"(x))
#define TOYTOP_BARRIER_double(x) __asm__("" : "+x"(x))
#elif defined(__GNUC__) && defined(__aarch64__)
#define TOYTOP_BARRIER_float(x) __asm__("" : "+w"(x))
#define TOYTOP_BARRIER_double(x) __asm__("" : "+w"(x))
#elif defined(__GNUC__) && (defined(__arm__) || defined(__riscv))
/* arithmetic in software has no fused operations */
#if defined(__ARM_FP) && (__ARM_FP & 4)
#define TOYTOP_BARRIER_float(x) __asm__("" : "+t"(x))
#elif defined(__riscv_flen)
#define TOYTOP_BARRIER_float(x) __asm__("" : "+f"(x))
#else
#define TOYTOP_BARRIER_float(x) (void)(x)
#endif
#if defined(__ARM_FP) && (__ARM_FP & 8)
#define TOYTOP_BARRIER_double(x) __asm__("" : "+w"(x))
#elif defined(__riscv_flen) && __riscv_flen >= 64
#define TOYTOP_BARRIER_double(x) __asm__("" : "+f"(x))
#else
#define TOYTOP_BARRIER_double(x) (void)(x)
#endif
#else
#define TOYTOP_BARRIER_float(x) do { volatile float kept = x; x = kept; } while (0)
#define TOYTOP_BARRIER_double(x) do { volatile double kept = x; x = kept; } while (0)
#endif

/* Angular velocity in numbers of the type F. */
#define TOYTOP_RATES(F) \
    static inline F toytop_rounded_##F(F x) { \
        TOYTOP_BARRIER_##F(x); \
        return x; \
    } \
    /* Sum a b + c d, with a barrier after each product. */ \
    static inline F toytop_inner_##F(F a, F b, F c, F d) { return toytop_rounded_##F(a * b) + toytop_rounded_##F(c * d); } \
    /* Angular velocity in the body frame from a and b and their derivatives, all rotated: the real and imaginary part of each. */ \
    static inline void toytop_body_rates_##F(const F four[4], const F slope[4], uint32_t depth, int falling, const F scales[4], \
                                             F omega[3]) { \
        const F *a = four, *b = four + 2, *da = slope, *db = slope + 2; \
        F n[2], x = (falling ? -scales[1] : scales[1]) * (F)(UINT32_C(1) << (depth - 3)), mean = scales[2]; \
        n[0] = toytop_inner_##F(a[0], db[0], a[1], db[1]) - toytop_inner_##F(b[0], da[0], b[1], da[1]); \
        n[1] = toytop_inner_##F(a[0], db[1], -a[1], db[0]) - toytop_inner_##F(b[0], -da[1], b[1], da[0]); \
        n[0] = toytop_rounded_##F(n[0] * x) - toytop_rounded_##F(toytop_inner_##F(a[0], b[1], -a[1], b[0]) * mean); \
        n[1] = toytop_rounded_##F(n[1] * x) + toytop_rounded_##F(toytop_inner_##F(a[0], b[0], a[1], b[1]) * mean); \
        omega[0] = n[1] * 2; \
        omega[1] = -n[0] * 2; \
        omega[2] = scales[3]; \
    } \
    /* Fixed coordinates of a vector in body coordinates; four: Re alpha, Im alpha, Re beta, Im beta. */ \
    static inline void toytop_adjoint_##F(const F four[4], const F v[3], F fixed[3]) { \
        const F *a = four, *b = four + 2; \
        F p[2], q[2]; \
        p[0] = toytop_inner_##F(a[0], v[0], -a[1], v[1]) - toytop_rounded_##F(b[0] * v[2]); \
        p[1] = toytop_inner_##F(a[0], v[1], a[1], v[0]) - toytop_rounded_##F(b[1] * v[2]); \
        q[0] = toytop_rounded_##F(a[0] * v[2]) + toytop_inner_##F(b[0], v[0], b[1], v[1]); \
        q[1] = toytop_rounded_##F(a[1] * v[2]) + toytop_inner_##F(b[0], -v[1], b[1], v[0]); \
        fixed[0] = toytop_inner_##F(a[0], p[0], -a[1], p[1]) - toytop_inner_##F(b[0], q[0], -b[1], q[1]); \
        fixed[1] = toytop_inner_##F(a[0], p[1], a[1], p[0]) - toytop_inner_##F(b[0], q[1], b[1], q[0]); \
        fixed[2] = toytop_inner_##F(a[0], q[0], a[1], q[1]) + toytop_inner_##F(b[0], p[0], b[1], p[1]); \
    }
