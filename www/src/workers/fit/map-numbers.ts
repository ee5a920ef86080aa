/** How many numbers a map of the paper's fit takes: 8 where x and y are copied apart (eq 8), else 10 (eq 9). */
export const numbersPerMap = (separable: boolean): number => (separable ? 8 : 10);
