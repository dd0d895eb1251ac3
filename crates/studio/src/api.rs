//! What a question is: its path, its schemas, and what answers it.

use crate::asker::Asker;
use crate::problem::Problem;
use crate::state::{Studio, superseded};
use axum::Router;
use axum::body::Bytes;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post, put};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::Arc;

/// A question, for [`crate::openapi`].
pub(crate) struct Endpoint {
    pub(crate) method: &'static str,
    pub(crate) path: &'static str,
    /// What it answers.
    pub(crate) doc: &'static str,
    pub(crate) question: Option<Schema>,
    pub(crate) answer: Answer,
}

/// What comes back.
pub(crate) enum Answer {
    Json(Schema),
    File(&'static str),
}

/// A file that is made on request.
pub(crate) struct Made {
    pub(crate) kind: &'static str,
    pub(crate) bytes: Vec<u8>,
}

/// Questions with their schemas, and what answers them; [`crate::openapi::all`] has all of them.
pub struct Api {
    router: Router<Arc<Studio>>,
    pub(crate) endpoints: Vec<Endpoint>,
    pub(crate) schemas: SchemaGenerator,
    /// Questions as they are read: what may be left out is not required.
    pub(crate) asked: SchemaGenerator,
}

impl Api {
    /// Without questions.
    pub(crate) fn new() -> Api {
        let generator = |settings: SchemaSettings| {
            let settings = settings.with(|settings| {
                settings.definitions_path = "/components/schemas".into();
                settings.meta_schema = None;
            });
            settings.into_generator()
        };
        let mut api = Api {
            router: Router::new(),
            endpoints: Vec::new(),
            schemas: generator(SchemaSettings::draft2020_12().for_serialize()),
            asked: generator(SchemaSettings::draft2020_12().for_deserialize()),
        };
        // What every question may get instead of its answer.
        api.schemas.subschema_for::<Problem>();
        api
    }

    /// A question without a body.
    pub(crate) fn get<T: Serialize + JsonSchema + 'static>(
        mut self,
        path: &'static str,
        doc: &'static str,
        answer: fn(&Asker) -> Result<T, Problem>,
    ) -> Api {
        let schema = Answer::Json(self.schemas.subschema_for::<T>());
        self.endpoints.push(Endpoint { method: "get", path, doc, question: None, answer: schema });
        let handler = move |state: axum::extract::State<Arc<Studio>>, headers: HeaderMap| async move {
            work(state.0, &headers, move |asker| json(&answer(asker)?)).await
        };
        self.router = self.router.route(path, get(handler));
        self
    }

    /// A question that is computed; of one lane only the newest is.
    pub(crate) fn post<
        Q: DeserializeOwned + JsonSchema + Send + 'static,
        T: Serialize + JsonSchema + 'static,
    >(
        self,
        path: &'static str,
        doc: &'static str,
        answer: fn(&Asker, Q) -> Result<T, Problem>,
    ) -> Api {
        self.with_body("post", path, doc, answer)
    }

    /// A question that changes a file.
    pub(crate) fn put<
        Q: DeserializeOwned + JsonSchema + Send + 'static,
        T: Serialize + JsonSchema + 'static,
    >(
        self,
        path: &'static str,
        doc: &'static str,
        answer: fn(&Asker, Q) -> Result<T, Problem>,
    ) -> Api {
        self.with_body("put", path, doc, answer)
    }

    fn with_body<Q: DeserializeOwned + JsonSchema + Send + 'static, T: Serialize + JsonSchema + 'static>(
        mut self,
        method: &'static str,
        path: &'static str,
        doc: &'static str,
        answer: fn(&Asker, Q) -> Result<T, Problem>,
    ) -> Api {
        let question = Some(self.schemas.subschema_for::<Q>());
        self.asked.subschema_for::<Q>();
        let schema = Answer::Json(self.schemas.subschema_for::<T>());
        self.endpoints.push(Endpoint { method, path, doc, question, answer: schema });
        let handler = move |state: axum::extract::State<Arc<Studio>>, headers: HeaderMap, body: Bytes| async move {
            work(state.0, &headers, move |asker| json(&answer(asker, question_of(&body)?)?)).await
        };
        self.router = self.router.route(path, if method == "put" { put(handler) } else { post(handler) });
        self
    }

    /// A question whose answer is a file.
    pub(crate) fn file<Q: DeserializeOwned + JsonSchema + Send + 'static>(
        mut self,
        path: &'static str,
        doc: &'static str,
        kind: &'static str,
        answer: fn(&Asker, Q) -> Result<Made, Problem>,
    ) -> Api {
        let question = Some(self.schemas.subschema_for::<Q>());
        self.asked.subschema_for::<Q>();
        self.endpoints.push(Endpoint { method: "post", path, doc, question, answer: Answer::File(kind) });
        let handler = move |state: axum::extract::State<Arc<Studio>>, headers: HeaderMap, body: Bytes| async move {
            work(state.0, &headers, move |asker| {
                let made = answer(asker, question_of(&body)?)?;
                let kind = HeaderValue::from_static(made.kind);
                Ok(([(header::CONTENT_TYPE, kind)], made.bytes).into_response())
            })
            .await
        };
        self.router = self.router.route(path, post(handler));
        self
    }

    /// What answers.
    pub(crate) fn router(self, studio: Arc<Studio>) -> Router {
        self.router.with_state(studio)
    }
}

fn question_of<Q: DeserializeOwned>(body: &[u8]) -> Result<Q, Problem> {
    serde_json::from_slice(body).map_err(|error| {
        let hint = "/api/openapi.json describes every question";
        Problem::new(StatusCode::BAD_REQUEST, format!("the question cannot be read: {error}"), hint)
    })
}

fn json(answer: &impl Serialize) -> Result<Response, Problem> {
    let bytes = serde_json::to_vec(answer).map_err(|error| {
        Problem::new(
            StatusCode::INTERNAL_SERVER_ERROR,
            format!("the answer cannot be written: {error}"),
            REPORT,
        )
    })?;
    Ok(([(header::CONTENT_TYPE, HeaderValue::from_static("application/json"))], bytes).into_response())
}

const REPORT: &str = "this is an internal error: please report it with the engine file";

/// Computes beside the server, so that it answers meanwhile; what nobody waits for any more is not begun.
async fn work(
    studio: Arc<Studio>,
    headers: &HeaderMap,
    answer: impl FnOnce(&Asker) -> Result<Response, Problem> + Send + 'static,
) -> Response {
    let text = |name: &str| headers.get(name).and_then(|value| value.to_str().ok());
    let place = text("x-lanchester-client")
        .zip(text("x-lanchester-lane"))
        .filter(|(client, lane)| client.len() + lane.len() < 200)
        .map(|(client, lane)| studio.lanes.enter(client, lane));
    let (asker, _waiting) = Asker::new(studio.clone(), place);
    let Ok(permit) = studio.processors.clone().acquire_owned().await else {
        return superseded().into_response();
    };
    let computed = tokio::task::spawn_blocking(move || {
        // What is computed holds its processor, whether or not somebody still waits for it.
        let _permit = permit;
        if asker.waits() { answer(&asker) } else { Err(superseded()) }
    });
    match computed.await {
        Ok(Ok(response)) => response,
        Ok(Err(problem)) => problem.into_response(),
        Err(_) => Problem::new(StatusCode::INTERNAL_SERVER_ERROR, "the computation broke off", REPORT)
            .into_response(),
    }
}
