//! Numbers and words in the attributes of SVG.

/// What is left of the value of an attribute.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scanner<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Scanner<'a> {
    pub fn new(text: &'a str) -> Scanner<'a> {
        Scanner { text, at: 0 }
    }

    /// Bytes read so far.
    pub fn at(&self) -> usize {
        self.at
    }

    fn rest(&self) -> &'a [u8] {
        &self.text.as_bytes()[self.at..]
    }

    fn skip(&mut self, is: impl Fn(u8) -> bool) {
        self.at += self.rest().iter().take_while(|byte| is(**byte)).count();
    }

    pub fn blanks(&mut self) {
        self.skip(|byte| matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | 0x0c));
    }

    /// Blanks with at most one comma.
    pub fn separator(&mut self) {
        self.blanks();
        if self.rest().first() == Some(&b',') {
            self.at += 1;
            self.blanks();
        }
    }

    pub fn is_done(&self) -> bool {
        self.rest().is_empty()
    }

    /// The next byte, without passing it.
    pub fn peek(&self) -> Option<u8> {
        self.rest().first().copied()
    }

    /// Passes this byte, if it is the next.
    pub fn take(&mut self, byte: u8) -> bool {
        let is = self.peek() == Some(byte);
        self.at += usize::from(is);
        is
    }

    /// Passes a letter.
    pub fn letter(&mut self) -> Option<u8> {
        let letter = self.peek().filter(u8::is_ascii_alphabetic)?;
        self.at += 1;
        Some(letter)
    }

    /// Passes letters; there may be none.
    pub fn word(&mut self) -> &'a str {
        let start = self.at;
        self.skip(|byte| byte.is_ascii_alphabetic());
        &self.text[start..self.at]
    }

    /// Passes a finite number.
    pub fn number(&mut self) -> Option<f64> {
        let start = *self;
        let digit = |byte: u8| byte.is_ascii_digit();
        self.skip_sign();
        self.skip(digit);
        if self.take(b'.') {
            self.skip(digit);
        }
        let mantissa = *self;
        if self.take(b'e') || self.take(b'E') {
            self.skip_sign();
            let digits = self.at;
            self.skip(digit);
            // Such as the unit em.
            if self.at == digits {
                *self = mantissa;
            }
        }
        let number = self.text[start.at..self.at].parse().ok().filter(|number: &f64| number.is_finite());
        if number.is_none() {
            *self = start;
        }
        number
    }

    fn skip_sign(&mut self) {
        if !self.take(b'-') {
            self.take(b'+');
        }
    }

    /// Passes a flag: a single 0 or 1, which needs no separator after it.
    pub fn flag(&mut self) -> Option<bool> {
        let flag = if self.take(b'1') { Some(true) } else { self.take(b'0').then_some(false) };
        flag.inspect(|_| self.separator())
    }

    /// A number and the separator after it.
    pub fn coordinate(&mut self) -> Option<f64> {
        self.number().inspect(|_| self.separator())
    }

    /// What stands here, for a message.
    pub fn here(&self) -> String {
        // Only ASCII is passed, so that this is the boundary of a character.
        let rest = self.text.get(self.at..).unwrap_or_default();
        if rest.is_empty() { "the end".to_string() } else { rest.chars().take(20).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::Scanner;

    #[test]
    fn numbers_need_no_blanks_between() {
        let mut scanner = Scanner::new("-1.5.5e1-2E-1+3em");
        let numbers: Vec<f64> = std::iter::from_fn(|| scanner.coordinate()).collect();
        assert_eq!(numbers, [-1.5, 5.0, -0.2, 3.0]);
        assert_eq!(scanner.word(), "em");
        for no in ["", ".", "-", "e5", "nan", "inf", "1e999"] {
            let mut scanner = Scanner::new(no);
            assert_eq!(scanner.number(), None, "{no}");
            assert_eq!(scanner.at(), 0);
        }
    }
}
