//! Who may ask: pages of this server that know its token, on this machine.

use axum::http::{HeaderMap, HeaderName, Uri, header};
use lanchester_answers::{Problem, Status};

/// The header that holds the token.
pub(crate) const TOKEN: &str = "x-lanchester-token";

/// What a question must bring.
#[derive(Debug, Clone)]
pub(crate) struct Gate {
    token: String,
    /// The port of the server.
    port: u16,
}

impl Gate {
    pub(crate) fn new(token: String, port: u16) -> Gate {
        Gate { token, port }
    }

    /// Whether `host` means this server: a name that somebody points here does not (DNS rebinding).
    fn is_own(&self, host: &str) -> bool {
        ["127.0.0.1", "localhost", "[::1]"].iter().any(|name| host == format!("{name}:{}", self.port))
    }

    /// Lets a question for any address pass, or tells why not.
    pub(crate) fn check_place(&self, headers: &HeaderMap, uri: &Uri) -> Result<(), Problem> {
        let refused = |what: String| {
            Problem::new(
                Status::Forbidden,
                what,
                format!("open the address that `lanchester studio` printed, http://127.0.0.1:{}", self.port),
            )
        };
        let host = match one(headers, &header::HOST) {
            Some(Some(host)) => host,
            Some(None) => return Err(refused("a question names one host, got none".to_string())),
            None => {
                return Err(refused("a question names one host, got several or none in ASCII".to_string()));
            }
        };
        // An address with a host of its own (as to a proxy) goes before the header.
        let others = uri.authority().map(|authority| authority.as_str()).into_iter();
        for host in std::iter::once(host).chain(others) {
            if !self.is_own(host) {
                return Err(refused(format!(
                    "the studio answers to this machine alone, got the host {host}"
                )));
            }
        }
        match one(headers, &header::ORIGIN) {
            Some(None) => Ok(()),
            Some(Some(origin)) if origin.strip_prefix("http://").is_some_and(|host| self.is_own(host)) => {
                Ok(())
            }
            Some(Some(origin)) => {
                Err(refused(format!("the studio answers its own page alone, got the origin {origin}")))
            }
            None => Err(refused("the studio answers its own page alone, got several origins".to_string())),
        }
    }

    /// Lets a question for data pass, or tells why not; events bring the token in the address.
    pub(crate) fn check_token(&self, headers: &HeaderMap, uri: &Uri) -> Result<(), Problem> {
        let mut of_headers = headers.get_all(TOKEN).iter();
        let of_header = of_headers.next().map(|value| value.as_bytes().to_vec());
        let of_address = || {
            let pairs = uri.query()?.split('&').filter_map(|pair| pair.split_once('='));
            pairs.into_iter().find(|(key, _)| *key == "token").map(|(_, value)| value.as_bytes().to_vec())
        };
        let given = of_header.or_else(of_address).unwrap_or_default();
        if same(&given, self.token.as_bytes()) && of_headers.next().is_none() {
            return Ok(());
        }
        Err(Problem::new(
            Status::Unauthorised,
            "the address of this page has no valid token",
            "open the address that `lanchester studio` printed when it was started last",
        ))
    }
}

/// The one value of a header; `Some(None)` where there is none, `None` where there are several or it is no text.
fn one<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<Option<&'a str>> {
    let mut all = headers.get_all(name).iter();
    match (all.next(), all.next()) {
        (None, _) => Some(None),
        (Some(value), None) => value.to_str().ok().map(Some),
        (Some(_), Some(_)) => None,
    }
}

/// Equality whose time does not tell where two texts differ.
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).fold(0, |differs, (a, b)| differs | (a ^ b)) == 0
}

/// 128 random bits as a word.
pub(crate) fn random_token() -> Result<String, getrandom::Error> {
    let mut bytes = [0u8; 16];
    getrandom::fill(&mut bytes)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headers(pairs: &[(&'static str, &'static str)]) -> HeaderMap {
        pairs
            .iter()
            .map(|(name, value)| (name.parse().unwrap(), value.parse().unwrap()))
            .collect::<HeaderMap>()
    }

    #[test]
    fn only_the_own_page_may_ask() {
        let gate = Gate::new("word".into(), 7000);
        let passes = |pairs: &[(&'static str, &'static str)]| {
            gate.check_place(&headers(pairs), &Uri::from_static("/api/session")).is_ok()
        };
        assert!(passes(&[("host", "127.0.0.1:7000")]));
        assert!(passes(&[("host", "localhost:7000"), ("origin", "http://127.0.0.1:7000")]));
        assert!(!passes(&[]));
        assert!(!passes(&[("host", "evil.example:7000")]));
        assert!(!passes(&[("host", "127.0.0.1:7001")]));
        assert!(!passes(&[("host", "127.0.0.1:7000"), ("origin", "http://evil.example")]));
        assert!(!passes(&[("host", "127.0.0.1:7000"), ("origin", "null")]));
        assert!(!passes(&[("host", "127.0.0.1:7000"), ("host", "127.0.0.1:7000")]));
        assert!(!passes(&[("host", "127.0.0.1:7000"), ("host", "evil.example")]));
        let own = ("origin", "http://127.0.0.1:7000");
        assert!(!passes(&[("host", "127.0.0.1:7000"), own, own]));
        let host = headers(&[("host", "127.0.0.1:7000")]);
        assert!(gate.check_place(&host, &Uri::from_static("http://127.0.0.1:7000/")).is_ok());
        assert!(gate.check_place(&host, &Uri::from_static("http://evil.example/")).is_err());
    }

    #[test]
    fn only_with_the_token() {
        let gate = Gate::new("word".into(), 7000);
        let uri = |text: &str| text.parse::<Uri>().unwrap();
        assert!(gate.check_token(&headers(&[(TOKEN, "word")]), &uri("/api/session")).is_ok());
        assert!(gate.check_token(&headers(&[]), &uri("/api/events?token=word")).is_ok());
        assert!(gate.check_token(&headers(&[(TOKEN, "sword")]), &uri("/api/session")).is_err());
        assert!(gate.check_token(&headers(&[(TOKEN, "")]), &uri("/api/events?token=wor")).is_err());
    }

    #[test]
    fn tokens_are_long_and_differ() {
        let (a, b) = (random_token().unwrap(), random_token().unwrap());
        assert!(a.len() == 32 && a != b);
    }
}
