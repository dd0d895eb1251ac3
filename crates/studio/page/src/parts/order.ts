// Orders as they are written everywhere on the page: decimals, as in tables and reports of the program.

/** `1`, `0.5`, `4.5`. */
export function orderName(order: number): string {
  return String(Number(order.toFixed(3)));
}

/** `order 4.5` */
export function orderTitle(order: number): string {
  return `order ${orderName(order)}`;
}
