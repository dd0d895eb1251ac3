//! What a question is: its path, its schemas, and what answers it.

use crate::asker::Asker;
use crate::problem::{Problem, Status};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// What is asked, as it was carried here.
#[derive(Debug, Clone, Copy)]
pub struct Question<'a> {
    /// `GET`, `POST` or `PUT`.
    pub method: &'a str,
    /// Its path.
    pub path: &'a str,
    /// JSON; empty for a question without a body.
    pub body: &'a [u8],
}

/// What comes back, to be carried as it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reply {
    /// The number that HTTP has for this kind of answer; 200 where there is one.
    pub status: u16,
    /// The media type of the bytes.
    pub kind: &'static str,
    /// A file, or JSON: an answer or a [`Problem`].
    pub bytes: Vec<u8>,
}

impl From<Problem> for Reply {
    fn from(problem: Problem) -> Reply {
        let bytes = serde_json::to_vec(&problem).unwrap_or_default();
        Reply { status: problem.status as u16, kind: JSON, bytes }
    }
}

const JSON: &str = "application/json";
const REPORT: &str = "this is an internal error: please report it with the engine file";

/// From the bytes of a question to its answer.
type AnswerFn = Box<dyn Fn(&Asker, &[u8]) -> Result<Made, Problem> + Send + Sync>;

/// All questions with what answers them.
pub struct Answers(Vec<(Place, AnswerFn)>);

/// Where a question is asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Place {
    method: &'static str,
    path: &'static str,
}

impl Answers {
    /// Every question: its method in capitals and its path.
    pub fn places(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.0.iter().map(|(place, _)| (place.method, place.path))
    }

    /// The answer to a question, or why there is none.
    pub fn answer(&self, asker: &Asker, question: Question) -> Reply {
        let is_asked = |place: &Place| place.path == question.path && place.method == question.method;
        let Some((_, answer)) = self.0.iter().find(|(place, _)| is_asked(place)) else {
            let message = format!("the studio has no question {} {}", question.method, question.path);
            return Problem::new(Status::NoSuchQuestion, message, OPENAPI).into();
        };
        match answer(asker, question.body) {
            Ok(made) => Reply { status: 200, kind: made.kind, bytes: made.bytes },
            Err(problem) => problem.into(),
        }
    }
}

const OPENAPI: &str = "/api/openapi.json describes every question";

/// What a question whose computation broke off gets.
pub fn broken_off() -> Problem {
    Problem::new(Status::Broken, "the computation broke off", REPORT)
}

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
pub(crate) struct Api {
    answers: Answers,
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
            answers: Answers(Vec::new()),
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
        self.answered("GET", path, move |asker, _| json(&answer(asker)?));
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
        let capitals = if method == "put" { "PUT" } else { "POST" };
        self.answered(capitals, path, move |asker, body| json(&answer(asker, question_of(body)?)?));
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
        self.answered("POST", path, move |asker, body| answer(asker, question_of(body)?));
        self
    }

    fn answered(
        &mut self,
        method: &'static str,
        path: &'static str,
        answer: impl Fn(&Asker, &[u8]) -> Result<Made, Problem> + Send + Sync + 'static,
    ) {
        self.answers.0.push((Place { method, path }, Box::new(answer)));
    }

    /// What answers.
    pub(crate) fn answers(self) -> Answers {
        self.answers
    }
}

fn question_of<Q: DeserializeOwned>(body: &[u8]) -> Result<Q, Problem> {
    serde_json::from_slice(body).map_err(|error| {
        Problem::new(Status::BadQuestion, format!("the question cannot be read: {error}"), OPENAPI)
    })
}

fn json(answer: &impl Serialize) -> Result<Made, Problem> {
    let bytes = serde_json::to_vec(answer).map_err(|error| {
        Problem::new(Status::Broken, format!("the answer cannot be written: {error}"), REPORT)
    })?;
    Ok(Made { kind: JSON, bytes })
}
