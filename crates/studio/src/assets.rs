//! The page, as it was built into the program.

use axum::http::{HeaderValue, StatusCode, Uri, header};
use axum::response::{IntoResponse, Response};

#[derive(rust_embed::RustEmbed)]
#[folder = "dist"]
struct Page;

/// Licences and notices of everything by others that the program and its page contain.
pub const THIRD_PARTY: &str = include_str!("../third-party.txt");

/// Where the page has them.
const NOTICES: &str = "third-party.txt";

/// Everything that the page may load stands on this server; three.js sets styles of its canvas by script.
const POLICY: &str = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; \
                      worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// A file of the page.
pub(crate) async fn asset(uri: Uri) -> Response {
    let path = uri.path().trim_start_matches('/');
    let path = if path.is_empty() { "index.html" } else { path };
    if path == NOTICES {
        return THIRD_PARTY.into_response();
    }
    let Some(file) = Page::get(path) else {
        return (StatusCode::NOT_FOUND, "the studio has no such page").into_response();
    };
    let kind = match path.rsplit_once('.').map(|(_, ending)| ending) {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("svg") => "image/svg+xml",
        _ => "application/octet-stream",
    };
    let headers = [
        (header::CONTENT_TYPE, HeaderValue::from_static(kind)),
        (header::CONTENT_SECURITY_POLICY, HeaderValue::from_static(POLICY)),
    ];
    (headers, file.data.into_owned()).into_response()
}
