//! Steps one after another or beside one another, each with its time; the first failure stops them, or all failures are told at the end.

use anyhow::{Context, Result, ensure};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard};
use std::time::{Duration, Instant};

type Work<'a> = Box<dyn FnOnce() -> Result<String> + Send + 'a>;

/// Steps that run one after another, beside those of other lanes.
#[derive(Default)]
pub struct Lane<'a> {
    steps: Vec<(&'static str, Work<'a>)>,
}

impl<'a> Lane<'a> {
    /// One without steps.
    pub fn new() -> Lane<'a> {
        Lane::default()
    }

    /// One step more; what it returns is a remark for the list, what it fails with is its output.
    pub fn step(mut self, name: &'static str, work: impl FnOnce() -> Result<String> + Send + 'a) -> Lane<'a> {
        self.steps.push((name, Box::new(work)));
        self
    }
}

/// Steps that are done.
#[derive(Default)]
pub struct Steps {
    /// Whether steps go on after a failure.
    goes_on: bool,
    /// Steps whose names do not hold this are left out.
    only: String,
    failed: Vec<String>,
    done: Vec<Done>,
    /// From the first step to the last.
    time: Duration,
}

/// A step that is done: its name, its time, its remark.
type Done = (&'static str, Duration, String);

impl Steps {
    /// Steps that go on after a failure: [`Steps::finish`] tells all of them.
    pub fn to_the_end() -> Steps {
        Steps { goes_on: true, ..Steps::default() }
    }

    /// Only the steps whose names hold a text.
    pub fn only(text: &str) -> Steps {
        Steps { only: text.to_owned(), ..Steps::default() }
    }

    /// Runs one step.
    pub fn run<'a>(
        &mut self,
        name: &'static str,
        work: impl FnOnce() -> Result<String> + Send + 'a,
    ) -> Result<()> {
        self.beside(vec![Lane::new().step(name, work)])
    }

    /// Runs lanes beside one another; after a failure no further step begins, unless steps go on to the end.
    pub fn beside(&mut self, lanes: Vec<Lane>) -> Result<()> {
        let start = Instant::now();
        let (goes_on, only) = (self.goes_on, self.only.as_str());
        let (done, told) = (Mutex::new(Vec::new()), Mutex::new(Vec::new()));
        let failed = AtomicBool::new(false);
        let results: Vec<Result<()>> = std::thread::scope(|scope| {
            let threads: Vec<_> = lanes
                .into_iter()
                .map(|lane| {
                    let (done, told, failed) = (&done, &told, &failed);
                    scope.spawn(move || -> Result<()> {
                        for (name, work) in lane.steps.into_iter().filter(|(name, _)| name.contains(only)) {
                            if failed.load(Ordering::Relaxed) {
                                break;
                            }
                            match one(name, work) {
                                Ok(own) => locked(done).push(own),
                                Err(error) if goes_on => {
                                    println!("error: {error:#}");
                                    locked(told).push(name.to_owned());
                                }
                                Err(error) => {
                                    failed.store(true, Ordering::Relaxed);
                                    return Err(error);
                                }
                            }
                        }
                        Ok(())
                    })
                })
                .collect();
            threads
                .into_iter()
                .map(|thread| thread.join().unwrap_or_else(|_| Err(anyhow::anyhow!("a step panicked"))))
                .collect()
        });
        self.time += start.elapsed();
        self.done.extend(done.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner()));
        self.failed.extend(told.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner()));
        results.into_iter().collect()
    }

    /// Prints the list of all.
    ///
    /// # Errors
    /// The steps that failed, where steps go on after a failure; no step that has the name asked for.
    pub fn finish(&self) -> Result<()> {
        ensure!(!self.done.is_empty() || !self.failed.is_empty(), "no step has `{}` in its name", self.only);
        let all = if self.only.is_empty() { "all steps passed" } else { "all chosen steps passed" };
        println!("\n{}", if self.failed.is_empty() { all } else { "steps that passed" });
        for (name, time, remark) in &self.done {
            println!("{:8.1} s  {name:50} {remark}", time.as_secs_f64());
        }
        println!(
            "{:8.1} s  in all, where steps beside one another share the processors",
            self.time.as_secs_f64()
        );
        ensure!(self.failed.is_empty(), "steps failed: {}", self.failed.join("; "));
        Ok(())
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

fn one(name: &'static str, work: Work) -> Result<Done> {
    println!("== {name}");
    let start = Instant::now();
    let remark = work().with_context(|| format!("step failed: {name}"))?;
    let time = start.elapsed();
    println!("   {:.1} s  {name}: {}", time.as_secs_f64(), if remark.is_empty() { "done" } else { &remark });
    Ok((name, time, remark))
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::bail;
    use std::sync::mpsc::channel;

    #[test]
    fn lanes_run_beside_one_another_and_their_steps_in_order() {
        let (to_right, from_left) = channel();
        let (to_left, from_right) = channel();
        let mut steps = Steps::default();
        // Each lane waits for the other's first step.
        let left = Lane::new()
            .step("left", move || Ok(to_right.send(()).map(|()| String::new())?))
            .step("left again", move || Ok(from_right.recv().map(|()| "heard".to_owned())?));
        let right = Lane::new()
            .step("right", move || Ok(to_left.send(()).map(|()| String::new())?))
            .step("right again", move || Ok(from_left.recv().map(|()| "heard".to_owned())?));
        steps.beside(vec![left, right]).expect("both lanes pass");
        let heard = steps.done.iter().filter(|(_, _, remark)| remark == "heard").count();
        assert_eq!((steps.done.len(), heard), (4, 2));
    }

    #[test]
    fn a_failure_stops_its_lane_and_is_told_with_its_step() {
        let mut steps = Steps::default();
        let lane = Lane::new()
            .step("first", || bail!("broken"))
            .step("second", || panic!("it must not run after a failure"));
        let error = steps.beside(vec![lane]).expect_err("the first step fails");
        assert_eq!(format!("{error:#}"), "step failed: first: broken");
        assert!(steps.done.is_empty());
    }

    #[test]
    fn only_the_chosen_steps_run() {
        let lane =
            || Lane::new().step("first", || panic!("it is not chosen")).step("second", || Ok(String::new()));
        let mut steps = Steps::only("sec");
        steps.beside(vec![lane()]).expect("the second passes");
        assert_eq!(steps.done.len(), 1);
        steps.finish().expect("one step passed");
        let mut none = Steps::only("third");
        none.beside(vec![lane()]).expect("nothing runs");
        let error = none.finish().expect_err("there is no such step");
        assert_eq!(format!("{error:#}"), "no step has `third` in its name");
    }

    #[test]
    fn all_failures_are_told_where_steps_go_on() {
        let mut steps = Steps::to_the_end();
        let lane = Lane::new()
            .step("first", || bail!("broken"))
            .step("second", || Ok(String::new()))
            .step("third", || bail!("broken too"));
        steps.beside(vec![lane]).expect("failures wait for the end");
        assert_eq!(steps.done.len(), 1);
        let error = steps.finish().expect_err("two steps failed");
        assert_eq!(format!("{error:#}"), "steps failed: first; third");
    }
}
