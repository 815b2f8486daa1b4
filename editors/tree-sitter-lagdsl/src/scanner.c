// The unit of a quantity: factors joined by `.`, at most one `/`, and no word character behind.
// tree-sitter's patterns look not beyond a token, so that `5 mass` would begin with `5 m`.

#include <string.h>

#include "tree_sitter/parser.h"
#include "units.h"

enum { UNIT, ERROR };
enum { LONGEST = 8 };

void *tree_sitter_lagdsl_external_scanner_create(void) { return NULL; }
void tree_sitter_lagdsl_external_scanner_destroy(void *state) { (void)state; }
unsigned tree_sitter_lagdsl_external_scanner_serialize(void *state, char *buffer) {
  (void)state;
  (void)buffer;
  return 0;
}
void tree_sitter_lagdsl_external_scanner_deserialize(void *state, const char *buffer, unsigned length) {
  (void)state;
  (void)buffer;
  (void)length;
}

static bool is_letter(int32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static bool is_power(int32_t c) { return c >= '1' && c <= '9'; }
static bool goes_on(int32_t c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '^' || c == '%'; }

static bool is_unit(const char *word) {
  for (unsigned k = 0; k < sizeof UNITS / sizeof *UNITS; k++)
    if (strcmp(UNITS[k], word) == 0) return true;
  return false;
}

// `m`, `s2`, `s^-1`, `%`
static bool factor(TSLexer *lexer) {
  if (lexer->lookahead == '%') {
    lexer->advance(lexer, false);
    return true;
  }
  char word[LONGEST + 1] = {0};
  for (unsigned k = 0; is_letter(lexer->lookahead); k++) {
    if (k == LONGEST) return false;
    word[k] = (char)lexer->lookahead;
    lexer->advance(lexer, false);
  }
  if (!is_unit(word)) return false;
  if (is_power(lexer->lookahead)) {
    lexer->advance(lexer, false);
  } else if (lexer->lookahead == '^') {
    lexer->advance(lexer, false);
    if (lexer->lookahead == '-') lexer->advance(lexer, false);
    if (!is_power(lexer->lookahead)) return false;
    lexer->advance(lexer, false);
  }
  return true;
}

// Factors joined by `.`; the token ends behind the last that is one. `*at_end`: reading has gone no further.
static bool factors(TSLexer *lexer, bool *at_end) {
  bool found = false;
  while (factor(lexer) && !goes_on(lexer->lookahead)) {
    lexer->mark_end(lexer);
    found = true;
    *at_end = lexer->lookahead != '.';
    if (*at_end) return true;
    lexer->advance(lexer, false);
  }
  *at_end = false;
  return found;
}

bool tree_sitter_lagdsl_external_scanner_scan(void *state, TSLexer *lexer, const bool *valid) {
  (void)state;
  if (!valid[UNIT] || valid[ERROR]) return false;
  bool blank = false, at_end = false;
  for (; lexer->lookahead == ' ' || lexer->lookahead == '\t'; blank = true) lexer->advance(lexer, true);
  lexer->result_symbol = UNIT;
  if (lexer->lookahead == '/') {  // `5 /s`
    if (!blank) return false;
    lexer->advance(lexer, false);
    return factors(lexer, &at_end);
  }
  if (!factors(lexer, &at_end)) return false;
  if (at_end && lexer->lookahead == '/') {
    lexer->advance(lexer, false);
    factors(lexer, &at_end);
  }
  return true;
}
