//! Questions that come to the server: who waits, whose turn it is, and the answer as a response.

use crate::lanes::Lanes;
use axum::Router;
use axum::body::Bytes;
use axum::extract::State;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{MethodFilter, on};
use lanchester_answers::{Answers, Asker, Problem, Question, Reply, Studio, broken_off, superseded};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tokio::sync::Semaphore;

/// What questions that come to the server are answered by.
pub(crate) struct Desk {
    pub(crate) studio: Studio,
    answers: Answers,
    lanes: Lanes,
    /// Computations at a time: as many as there are processors.
    processors: Arc<Semaphore>,
}

impl Desk {
    pub(crate) fn new(studio: Studio, processors: usize) -> Desk {
        let processors = Arc::new(Semaphore::new(processors));
        Desk { studio, answers: lanchester_answers::answers(), lanes: Lanes::default(), processors }
    }
}

/// Set when the answer is waited for no more: the server drops it when the connection is closed.
struct Waiting(Arc<AtomicBool>);

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Every question of the one list.
pub(crate) fn router(desk: Arc<Desk>) -> Router {
    let mut router = Router::new();
    for (method, path) in desk.answers.places() {
        let filter = match method {
            "GET" => MethodFilter::GET,
            "PUT" => MethodFilter::PUT,
            _ => MethodFilter::POST,
        };
        let handler = move |State(desk): State<Arc<Desk>>, headers: HeaderMap, body: Bytes| async move {
            work(desk, &headers, method, path, body).await
        };
        router = router.route(path, on(filter, handler));
    }
    router.with_state(desk)
}

/// Computes beside the server, so that it answers meanwhile; what nobody waits for any more is not begun.
async fn work(
    desk: Arc<Desk>,
    headers: &HeaderMap,
    method: &'static str,
    path: &'static str,
    body: Bytes,
) -> Response {
    let text = |name: &str| headers.get(name).and_then(|value| value.to_str().ok());
    let place = text("x-lanchester-client")
        .zip(text("x-lanchester-lane"))
        .filter(|(client, lane)| client.len() + lane.len() < 200)
        .map(|(client, lane)| desk.lanes.enter(client, lane));
    let gone = Arc::new(AtomicBool::new(false));
    let _waiting = Waiting(gone.clone());
    let Ok(permit) = desk.processors.clone().acquire_owned().await else {
        return refused(superseded());
    };
    let computed = tokio::task::spawn_blocking(move || {
        // What is computed holds its processor, whether or not somebody still waits for it.
        let _permit = permit;
        let is_newest = || place.as_ref().is_none_or(|place| desk.lanes.is_newest(place));
        let waits = || is_newest() && !gone.load(Ordering::Relaxed);
        let question = Question { method, path, body: &body };
        match waits() {
            true => desk.answers.answer(&Asker::new(&desk.studio, &waits), question),
            false => superseded().into(),
        }
    });
    response(computed.await.unwrap_or_else(|_| broken_off().into()))
}

/// An answer as it is carried back.
fn response(reply: Reply) -> Response {
    let status = StatusCode::from_u16(reply.status).unwrap_or(StatusCode::INTERNAL_SERVER_ERROR);
    let kind = HeaderValue::from_static(reply.kind);
    (status, [(header::CONTENT_TYPE, kind)], reply.bytes).into_response()
}

/// A refusal as it is carried back.
pub(crate) fn refused(problem: Problem) -> Response {
    response(problem.into())
}
