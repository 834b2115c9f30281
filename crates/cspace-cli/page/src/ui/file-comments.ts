/** What the comment in a model's file says of a parameter, on its line; empty if it has none there. */
export function commentOf(text: string, name: string): string {
  const section = /^\[parameter\]\s*(?:#.*)?$([^]*?)(?=^\[|(?![^]))/m.exec(text)?.[1] ?? "";
  // A hash within quotes begins no comment.
  const line = section.split("\n").find((l) => new RegExp(`^\\s*"?${name.replace(/[^\w]/g, "\\$&")}"?\\s*=`).test(l)) ?? "";
  return /^(?:"[^"]*"|'[^']*'|[^"'#])*#\s*(.*?)\s*$/.exec(line)?.[1] ?? "";
}
